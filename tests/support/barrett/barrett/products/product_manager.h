// Stands in for libbarrett's header: a safety module that lets the arm be active, and idle when it is asked to be.
// Source: libbarrett, products/product_manager.h (getSafetyModule), products/safety_module.h (getMode, waitForMode, its modes).
#pragma once

namespace barrett {

class SafetyModule {
  public:
    enum SafetyMode { ESTOP, IDLE, ACTIVE };
    SafetyMode getMode() const { return ACTIVE; }
    void waitForMode(SafetyMode /*mode*/) {}
};

class ProductManager {
  public:
    SafetyModule* getSafetyModule() { return &module_; }

  private:
    SafetyModule module_;
};

}  // namespace barrett
