using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>A test of a real window that belongs to <c>./test --full</c>; it is not part of the fast subset.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class FullRunXServerFactAttribute : FullRunFactAttribute
{
    public FullRunXServerFactAttribute() => Skip = new XServerFactAttribute().Skip;
}
