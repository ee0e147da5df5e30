using Engraver.Benchmarks.Stages;

namespace Engraver.Benchmarks.Motion.Parts;

/// <summary>The parts whose motion is measured. The same drawings in every run.</summary>
internal static class BenchmarkPart
{
    private static readonly Dictionary<string, Action<DxfFile>> s_parts = new()
    {
        ["plate"] = Plate,
        ["gear"] = Gear,
        ["text-outline"] = file => Text(file, Letters.Outlined, 1),
        ["text-single"] = file => Text(file, Letters.Single, 2),
        ["spiral"] = Spiral,
        ["logo"] = Logo,
        ["rose"] = Rose,
        ["hatch"] = Hatch,
        ["figure"] = Figure,
    };

    /// <summary>Where the elements of a tooth begin and end, parts of its angle.</summary>
    private static readonly double[] s_tooth = [0.0, 0.3, 0.4, 0.6, 0.7, 1.0];

    /// <summary>Writes one drawing for each part.</summary>
    public static void WriteAll(string folder)
    {
        Directory.CreateDirectory(folder);
        foreach (var (name, draw) in s_parts)
        {
            var file = new DxfFile();
            draw(file);
            file.Save(Path.Combine(folder, name + ".dxf"));
        }
    }

    /// <summary>200 holes in a plate with round corners.</summary>
    private static void Plate(DxfFile file)
    {
        var random = new SeededSequence(200);
        for (var hole = 0; hole < 200; hole++) file.Circle(9.0 + (8.0 * (hole % 20)), 9.0 + (8.0 * (hole / 20)), 0.75 + (0.25 * random.Below(9)));
        var quarter = Math.Tan(Math.PI / 8.0);
        file.Add(Outline.Closed(
            (5.0, 0.0, 0.0), (165.0, 0.0, quarter), (170.0, 5.0, 0.0), (170.0, 85.0, quarter),
            (165.0, 90.0, 0.0), (5.0, 90.0, quarter), (0.0, 85.0, 0.0), (0.0, 5.0, quarter)));
    }

    /// <summary>60 teeth: arcs at the root and at the tip, joined by lines.</summary>
    private static void Gear(DxfFile file)
    {
        const int Teeth = 60;
        const double Root = 28.75;
        const double Tip = 31.0;
        file.Circle(0.0, 0.0, 8.0);
        for (var tooth = 0; tooth < Teeth; tooth++)
        {
            double[] degrees = [.. s_tooth.Select(part => 360.0 * (tooth + part) / Teeth)];
            Plane[] ends = [.. degrees.Select((angle, i) => Plane.At(double.DegreesToRadians(angle)) * (i is 2 or 3 ? Tip : Root))];
            file.Arc(0.0, 0.0, Root, degrees[0], degrees[1]);
            file.Line(ends[1].X, ends[1].Y, ends[2].X, ends[2].Y);
            file.Arc(0.0, 0.0, Tip, degrees[2], degrees[3]);
            file.Line(ends[3].X, ends[3].Y, ends[4].X, ends[4].Y);
            file.Arc(0.0, 0.0, Root, degrees[4], degrees[5]);
        }
    }

    /// <summary>Four lines of 24 letters, 2 to 8 mm high.</summary>
    private static void Text(DxfFile file, IReadOnlyList<Outline[]> letters, ulong seed)
    {
        var (random, y) = (new SeededSequence(seed), 0.0);
        foreach (var height in new[] { 2.0, 3.0, 5.0, 8.0 })
        {
            for (var i = 0; i < 24; i++)
            {
                foreach (var outline in letters[random.Below(letters.Count)]) file.Add(outline.At(1.2 * height * i, y, height));
            }

            y += 1.5 * height;
        }
    }

    /// <summary>Half circles of growing radius.</summary>
    private static void Spiral(DxfFile file)
    {
        var (vertices, x, side) = (new List<(double X, double Y, double Bulge)>(), 0.0, 1.0);
        for (var half = 1; half <= 60; half++)
        {
            vertices.Add((x, 0.0, 1.0));
            x += side * 0.7 * half;
            side = -side;
        }

        vertices.Add((x, 0.0, 0.0));
        file.Add(new Outline(vertices, false));
    }

    /// <summary>Nested closed polylines of short sides, every third one an arc.</summary>
    private static void Logo(DxfFile file)
    {
        var random = new SeededSequence(7);
        for (var ring = 0; ring < 16; ring++)
        {
            var (sides, radius) = (60 + (6 * ring), 6.0 + (1.2 * ring));
            var vertices = new List<(double X, double Y, double Bulge)>();
            for (var i = 0; i < sides; i++)
            {
                var place = Plane.At(Math.Tau * (i + (0.3 * random.Fraction())) / sides) * (radius + (0.5 * random.Fraction()));
                vertices.Add((place.X, place.Y, i % 3 == 0 ? (random.Coin() ? 0.3 : -0.3) : 0.0));
            }

            file.Add(new Outline(vertices, true));
        }
    }

    /// <summary>r = 40 cos(5 a) in chords of equal angle.</summary>
    private static void Rose(DxfFile file)
    {
        const int Chords = 9205;
        var places = Enumerable.Range(0, Chords + 1).Select(i => Math.PI * i / Chords).Select(angle => Plane.At(angle) * (40.0 * Math.Cos(5.0 * angle)));
        file.Add(new Outline([.. places.Select(place => (place.X, place.Y, 0.0))], false));
    }

    /// <summary>300 parallel lines in one polyline.</summary>
    private static void Hatch(DxfFile file) =>
        file.Add(new Outline([.. Enumerable.Range(0, 600).Select(i => (i % 4 is 1 or 2 ? 60.0 : 0.0, 0.3 * (i / 2), 0.0))], false));

    /// <summary>An outline of lines and arcs, with corners and without, around holes and slots.</summary>
    private static void Figure(DxfFile file)
    {
        file.Line(0.0, 0.0, 40.0, 0.0);
        file.Arc(40.0, 10.0, 10.0, 270.0, 360.0);
        file.Line(50.0, 10.0, 50.0, 25.0);
        file.Arc(50.0, 30.0, 5.0, 90.0, 270.0);
        file.Line(50.0, 35.0, 50.0, 45.0);
        file.Line(50.0, 45.0, 35.0, 60.0);
        file.Arc(27.5, 60.0, 7.5, 0.0, 180.0);
        file.Line(20.0, 60.0, 10.0, 60.0);
        file.Arc(10.0, 50.0, 10.0, 90.0, 180.0);
        file.Line(0.0, 50.0, 0.0, 32.0);
        file.Line(0.0, 32.0, 4.0, 28.0);
        file.Line(4.0, 28.0, 0.0, 24.0);
        file.Line(0.0, 24.0, 0.0, 0.0);
        file.Circle(27.5, 60.0, 3.0);
        file.Circle(10.0, 50.0, 4.0);
        file.Add(Outline.Closed((10.0, 10.0, 0.0), (30.0, 10.0, 1.0), (30.0, 16.0, 0.0), (10.0, 16.0, 1.0)));
        file.Add(Outline.Closed((12.0, 24.0, 0.0), (38.0, 24.0, 0.0), (38.0, 38.0, -0.5), (12.0, 38.0, 0.0)));
    }
}
