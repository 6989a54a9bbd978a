# Peers: other libraries measured beside ours, from the packages that packages-peers.txt names. Each is a file here that
# includes that library alone; what is not installed is not built, and the page says so.
option(FULCRUM_PEERS "measure ODE, Bullet, MuJoCo, OpenVDB and FCL beside ours where they are installed" ON)
set(peer_sources "")
set(peer_libraries "")
set(peers_missing "")
