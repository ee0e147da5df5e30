namespace Engraver.App.Canvas.Colours;

/// <summary>Interpolates between two colours in equal steps.</summary>
internal static class ColourRamp
{
    public static uint[] Between(uint from, uint to, int steps)
    {
        var colours = new uint[steps];
        for (var i = 0; i < steps; i++) colours[i] = Mixed(from, to, steps == 1 ? 1.0 : i / (steps - 1.0));
        return colours;
    }

    /// <param name="share">0: the first colour, 1: the second.</param>
    public static uint Mixed(uint from, uint to, double share)
    {
        return 0xFF000000 | Channel(16) | Channel(8) | Channel(0);

        uint Channel(int shift)
        {
            var (a, b) = ((double)((from >> shift) & 0xFF), (double)((to >> shift) & 0xFF));
            return (uint)Math.Round(a + ((b - a) * share)) << shift;
        }
    }
}
