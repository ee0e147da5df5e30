using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;
using Xunit.Abstractions;
using Xunit.Sdk;

namespace Engraver.App.Tests.RealWindow;

/// <summary>A test of a real window that takes minutes. It belongs to <c>./test --full</c>; in a commit's share it is not among the tests.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer("Engraver.App.Tests.RealWindow.FullRunDiscoverer", "Engraver.App.Tests")]
public sealed class FullRunXServerFactAttribute : FactAttribute
{
    public FullRunXServerFactAttribute() => Skip = new XServerFactAttribute().Skip;
}

/// <summary>Finds the tests of <see cref="FullRunXServerFactAttribute"/> in the full run only.</summary>
public sealed class FullRunDiscoverer(IMessageSink sink) : FactDiscoverer(sink)
{
    public override IEnumerable<IXunitTestCase> Discover(ITestFrameworkDiscoveryOptions discoveryOptions, ITestMethod testMethod, IAttributeInfo factAttribute) =>
        TestExtent.IsFull ? base.Discover(discoveryOptions, testMethod, factAttribute) : [];
}
