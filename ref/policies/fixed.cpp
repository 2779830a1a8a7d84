// Plain selective rendering: the same threshold everywhere.
#include "ref/policy.h"

namespace artu::ref::policies {

int fixed(const Candidate&, const Settings& settings) { return clamped(settings.reference, settings); }

}  // namespace artu::ref::policies
