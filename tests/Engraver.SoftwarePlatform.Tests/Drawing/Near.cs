using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

internal static class Near
{
    public static void Equal(Color expected, Color actual, int tolerance = 2)
    {
        var largest = new[] { expected.A - actual.A, expected.R - actual.R, expected.G - actual.G, expected.B - actual.B }.Max(Math.Abs);
        Assert.True(largest <= tolerance, $"expected {expected}, got {actual}");
    }

    public static void Equal(double expected, double actual, double tolerance) =>
        Assert.True(Math.Abs(expected - actual) <= tolerance, $"expected {expected} +- {tolerance}, got {actual}");
}
