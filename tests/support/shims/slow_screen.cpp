// Stands before GLFW, so that a frame takes 200 ms to be seen, as on a computer that draws by software.
#include <chrono>
#include <dlfcn.h>
#include <thread>

struct GLFWwindow;

extern "C" void glfwSwapBuffers(GLFWwindow* window) {
    using Swap = void (*)(GLFWwindow*);
    static const auto kSwap = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glfwSwapBuffers"));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    kSwap(window);
}
