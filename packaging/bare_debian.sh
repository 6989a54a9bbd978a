# shellcheck shell=bash disable=SC2034,SC2154
# bare_debian.sh: read by what tries programs in a Debian 12 that has nothing of this machine (try.sh, cross_build.sh). They say in which
# folder it is ($bare), what is kept for the next time ($kept), and where all is told ($log).
suite=bookworm
apt="apt-get -y -qq -o Dpkg::Use-Pty=0 -o APT::Sandbox::User=root"
shown=() # which folders of this machine are seen in it, and where: FOLDER PLACE …
failed=0

not_run() {
    echo "not run: $*"
    exit 77
}

# need_bare_debian: ends where none can be made.
need_bare_debian() {
    [[ $EUID -eq 0 ]] || not_run "only root may make a bare Debian; start it with sudo"
    command -v debootstrap >/dev/null || not_run "debootstrap is missing; packages-package.txt names it"
    unshare --mount --pid --fork true 2>/dev/null || not_run "this machine allows no mounts of one's own"
}

# inside COMMAND…: in the bare Debian, with what a program may expect of the kernel, and nothing else of this machine but what is shown.
# Every mount ends with the process that made it.
inside() {
    # shellcheck disable=SC2016 # the inner shell's
    unshare --mount --propagation private --pid --fork --kill-child bash -euc '
        bare=$1
        shift
        mount -t proc proc "$bare/proc"
        mount -t tmpfs -o mode=755 dev "$bare/dev"
        for device in null zero full random urandom; do
            touch "$bare/dev/$device" && mount --bind "/dev/$device" "$bare/dev/$device"
        done
        mkdir "$bare/dev/shm" && mount -t tmpfs -o mode=1777 shm "$bare/dev/shm"
        ln -s /proc/self/fd "$bare/dev/fd"
        ln -s /proc/self/fd/1 "$bare/dev/stdout"
        while [ "$1" != -- ]; do
            if [ -d "$1" ]; then mkdir -p "$bare$2" && mount --bind "$1" "$bare$2"; fi
            shift 2
        done
        shift
        exec chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
    ' - "$bare" "$kept/archives" /var/cache/apt/archives "${shown[@]}" -- "$@"
}

# unpack_bare_debian: into $bare, which is empty.
unpack_bare_debian() {
    local mirror
    mkdir -p "$kept/archives/partial"
    if [[ ! -f $kept/base.tar ]]; then
        # shellcheck disable=SC2016 # apt's own
        mirror=$(apt-get indextargets --format '$(SITE) $(CODENAME)' 'Created-By: Packages' | awk -v suite="$suite" '$2 == suite { print $1; exit }')
        [[ -n $mirror ]] || not_run "apt knows no mirror of Debian $suite"
        echo "Fetching a bare Debian …"
        debootstrap --variant=minbase "$suite" "$bare" "$mirror" >>"$log" 2>&1 ||
            not_run "a bare Debian could not be fetched: $(tail -n 1 "$log")"
        # shellcheck disable=SC2086 # several words
        inside $apt update --error-on=any >>"$log" 2>&1 || not_run "the lists of packages could not be fetched: $(tail -n 1 "$log")"
        tar --numeric-owner --one-file-system -C "$bare" -cf "$kept/base.tar.part" . && mv "$kept/base.tar.part" "$kept/base.tar"
    else
        tar --numeric-owner -C "$bare" -xpf "$kept/base.tar"
    fi
    chmod 755 "$bare"
}

# claim WORDS COMMAND…: a line on whether it went well; what it says is in said.log.
claim() {
    local words=$1
    shift
    if "$@" >"$kept/said.log" 2>&1; then
        echo "  passed: $words"
    else
        echo "  FAILED: $words"
        tail -n 15 "$kept/said.log" | sed 's/^/    /'
        failed=1
    fi
    cat "$kept/said.log" >>"$log"
}

left_out=0
# leave_out WORDS REASON
leave_out() {
    echo "  not run: $1: $2"
    left_out=$((left_out + 1))
}
