using Engraver.Core.Drawings;

namespace Engraver.TestKit;

/// <summary>Drawings that several tests use by name.</summary>
public static class SampleDrawings
{
    /// <summary>Paper 001, figure 5: three lines and an arc (paper-001-readings.md, golden tables).</summary>
    public static Drawing PaperSample() => new DrawingBuilder()
        .Line(50, 50, 150, 50)
        .Line(150, 50, 150, 150)
        .Arc(100, 150, 50, 0, 180)
        .Line(50, 150, 50, 50)
        .Build();
}
