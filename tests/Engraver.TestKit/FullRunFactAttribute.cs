using Xunit;
using Xunit.Sdk;

namespace Engraver.TestKit;

/// <summary>A test of <c>./test --full</c> that a commit does not run: it takes long, and tests of a commit cover its parts one by one. State at the test which
/// tests these are.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer("Engraver.TestKit.FullRunFactDiscoverer", "Engraver.TestKit")]
public class FullRunFactAttribute : FactAttribute;
