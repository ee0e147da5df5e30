using Xunit;
using Xunit.Abstractions;
using Xunit.Sdk;

namespace Engraver.TestKit;

/// <summary>A test of <c>./test --full</c> that a commit does not run: it takes long, and tests of a commit cover its parts one by one. State at the test which
/// tests these are.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer("Engraver.TestKit.FullRunFactDiscoverer", "Engraver.TestKit")]
public class FullRunFactAttribute : FactAttribute;

/// <summary>The same for a test with data.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer("Engraver.TestKit.FullRunTheoryDiscoverer", "Engraver.TestKit")]
public class FullRunTheoryAttribute : TheoryAttribute;

/// <summary>Finds the tests of <see cref="FullRunFactAttribute"/> in the full run only.</summary>
public sealed class FullRunFactDiscoverer(IMessageSink sink) : FactDiscoverer(sink)
{
    public override IEnumerable<IXunitTestCase> Discover(ITestFrameworkDiscoveryOptions discoveryOptions, ITestMethod testMethod, IAttributeInfo factAttribute) =>
        TestExtent.IsFull ? base.Discover(discoveryOptions, testMethod, factAttribute) : [];
}

/// <summary>Finds the tests of <see cref="FullRunTheoryAttribute"/> in the full run only.</summary>
public sealed class FullRunTheoryDiscoverer(IMessageSink sink) : TheoryDiscoverer(sink)
{
    public override IEnumerable<IXunitTestCase> Discover(ITestFrameworkDiscoveryOptions discoveryOptions, ITestMethod testMethod, IAttributeInfo theoryAttribute) =>
        TestExtent.IsFull ? base.Discover(discoveryOptions, testMethod, theoryAttribute) : [];
}
