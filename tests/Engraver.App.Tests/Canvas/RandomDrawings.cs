using Engraver.Core.Drawings;
using Engraver.TestKit;

namespace Engraver.App.Tests.Canvas;

/// <summary>Seeded drawings of every kind of curve, some large, some small, one stray line far away, some hidden.</summary>
internal static class RandomDrawings
{
    public static Drawing Of(int seed, int count)
    {
        var random = new Random(seed);
        var drawing = new DrawingBuilder().Line(1e5, 1e5, 1e5 + 1.0, 1e5); // the stray line
        for (var i = 0; i < count; i++) Add(drawing, random, i);
        drawing.OnLayer(new Layer("frozen", On: true, Frozen: true, Plot: true)).Line(-50.0, -50.0, 150.0, 150.0);
        return drawing.Build();
    }

    private static void Add(DrawingBuilder drawing, Random random, int i)
    {
        var (x, y) = (random.NextDouble() * 100.0, random.NextDouble() * 100.0);
        var size = Math.Pow(10.0, (random.NextDouble() * 3.0) - 1.5);
        if (i % 5 == 0) drawing.Circle(x, y, size);
        else if (i % 5 == 1) drawing.Arc(x, y, size, random.Next(360), random.Next(360) + 0.5);
        else if (i % 5 == 2) drawing.Free(FreeCurves.Ellipse(x, y, size, 0.4, random.Next(360), 0.0, i % 2 == 0 ? 360.0 : 200.0).ToCurve());
        else if (i % 5 == 3) drawing.Square(x, y, size);
        else drawing.Line(x, y, x + (size * (random.NextDouble() - 0.5)), y + (size * (random.NextDouble() - 0.5)));
    }
}
