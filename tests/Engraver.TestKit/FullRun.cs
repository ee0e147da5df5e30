using Xunit.Abstractions;
using Xunit.Sdk;

namespace Engraver.TestKit;

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
