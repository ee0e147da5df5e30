using Xunit;
using Xunit.Sdk;

namespace Engraver.TestKit;

/// <summary>The same for a test with data.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer("Engraver.TestKit.FullRunTheoryDiscoverer", "Engraver.TestKit")]
public class FullRunTheoryAttribute : TheoryAttribute;
