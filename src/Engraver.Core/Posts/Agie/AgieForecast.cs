using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts.Agie;

/// <summary>Follows blocks from the start of the first stroke as the machine does, and measures how far it is from the path.</summary>
internal sealed class AgieForecast
{
    /// <summary>An end that lies as near to the start of a move as this, millimetres, comes back to it.</summary>
    private const double Same = 0.01;

    private const int FewestPlaces = 32;

    private readonly Toolpath _path;
    private readonly Point2D _entry;
    private readonly SegmentIndex _index;

    private AgieForecast(Toolpath path)
    {
        (_path, _entry) = (path, path.Strokes[0].Start);
        _index = new SegmentIndex([.. path.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment)]);
    }

    /// <param name="parts">How many of the steps each program has.</param>
    public static PostForecast Follow(Toolpath path, IReadOnlyList<AgieStep> steps, IReadOnlyList<int> parts)
    {
        var (forecast, place, part, number) = (new AgieForecast(path), default(Point2D), 0, 0);
        var blocks = new List<ForecastBlock>(steps.Count);
        for (var i = 0; i < steps.Count; i++)
        {
            var step = steps[i];
            if (number == parts[part]) (part, number) = (part + 1, 0);
            var run = step.Block.PathFrom(place);
            place = run.End;
            var isEnd = i + 1 == steps.Count || steps[i + 1].Stroke != step.Stroke;
            blocks.Add(new ForecastBlock(part + 1, ++number, step.Block.Cutting, forecast.Drawing(place), step.Drawn is { } drawn ? forecast.Error(run, drawn) : null, isEnd ? forecast.Closure(step.Stroke, place) : null));
        }

        return new PostForecast(forecast._entry, blocks, blocks.Max(block => block.Error ?? 0.0), blocks.Max(block => block.Closure));
    }

    /// <summary>Where the machine stands at the end of a stroke, which lies where one of its moves starts, from where it should.</summary>
    private double? Closure(int number, Point2D place)
    {
        var stroke = _path.Strokes[number];
        return stroke.Closed || stroke.Moves.Skip(1).Any(move => move.Segment.Start.DistanceTo(stroke.End) <= Same) ? Drawing(place).DistanceTo(stroke.End) : null;
    }

    /// <summary>At places on the run; between two of them the distance is larger by less than a thousandth of itself. What the run stands for is tried first, then everything that is cut.</summary>
    private double Error(in Segment run, in Segment drawn)
    {
        var (places, largest) = (run.Kind == SegmentKind.Line ? FewestPlaces : Math.Max(FewestPlaces, (int)Math.Abs(2.0 * run.Arc.Sweep.Degrees)), 0.0);
        for (var i = 0; i <= places; i++)
        {
            var place = Drawing(run.PointAt((double)i / places));
            var distance = drawn.DistanceTo(place);
            if (distance <= largest) continue;
            _index.NearestTo(place, out var nearest);
            largest = Math.Max(largest, Math.Min(distance, nearest));
        }

        return largest;
    }

    private Point2D Drawing(Point2D place) => new(_entry.X + (place.X / 1000.0), _entry.Y + (place.Y / 1000.0));
}
