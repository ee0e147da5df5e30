using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts.Agie;

/// <summary>Follows blocks from the start of the first stroke as the machine does, and measures its distance from the path.</summary>
internal sealed class AgieForecast
{
    /// <summary>An end that is this near to the start of a move, millimetres, counts as a return to it.</summary>
    private const double Same = 0.01;

    /// <summary>Minimum path length before a return, millimetres: a single short piece is not a return.</summary>
    private const double Away = 10.0 * Same;

    private const int MinPlaces = 32;

    private readonly Toolpath _path;
    private readonly Point2D _entry;
    private readonly SegmentIndex _index;

    /// <summary>Starts of the moves of a stroke before the current move, by cells of <see cref="Same"/>.</summary>
    private readonly Dictionary<(long X, long Y), List<(Point2D Place, double Way)>> _places = [];
    private double _way;
    private int _stroke = -1;
    private int _noted;

    private AgieForecast(Toolpath path)
    {
        (_path, _entry) = (path, path.Strokes[0].Start);
        _index = new SegmentIndex([.. path.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment)]);
    }

    /// <param name="parts">Number of steps of each program.</param>
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
            var isEnd = step.Move >= 0 && (i + 1 == steps.Count || (steps[i + 1].Stroke, steps[i + 1].Move) != (step.Stroke, step.Move));
            blocks.Add(new ForecastBlock(part + 1, ++number, step.Block.Cutting, forecast.Drawing(place), step.Drawn is { } drawn ? forecast.Error(run, drawn) : null, isEnd ? forecast.Closure(step, place) : null));
        }

        return new PostForecast(forecast._entry, blocks, blocks.Max(block => block.Error ?? 0.0), blocks.Max(block => block.Closure));
    }

    /// <summary>Closure: the distance of the machine position from the required position at the end of a move that returns to an earlier point of the stroke,
    /// also in the middle of a stroke that continues from there.</summary>
    private double? Closure(AgieStep step, Point2D place)
    {
        var stroke = _path.Strokes[step.Stroke];
        if (_stroke != step.Stroke) (_stroke, _noted) = (step.Stroke, 0);
        if (_noted == 0)
        {
            _places.Clear();
            _way = 0.0;
        }

        for (; _noted <= step.Move; _noted++)
        {
            Note(stroke.Moves[_noted].Segment.Start);
            _way += stroke.Moves[_noted].Segment.Length;
        }

        var (drawn, isLast) = (stroke.Moves[step.Move].Segment, step.Move == stroke.Moves.Count - 1);
        return (isLast && stroke.Closed) || HasVisited(drawn.End) ? Drawing(place).DistanceTo(drawn.End) : null;
    }

    private void Note(Point2D place)
    {
        var cell = CellOf(place);
        if (_places.TryGetValue(cell, out var there)) there.Add((place, _way));
        else _places.Add(cell, [(place, _way)]);
    }

    private bool HasVisited(Point2D place)
    {
        var (x, y) = CellOf(place);
        for (var i = -1; i <= 1; i++)
        {
            for (var j = -1; j <= 1; j++)
            {
                if (_places.TryGetValue((x + i, y + j), out var there) && there.Exists(one => one.Place.DistanceTo(place) <= Same && _way - one.Way > Away)) return true;
            }
        }

        return false;
    }

    private static (long X, long Y) CellOf(Point2D place) => ((long)Math.Floor(place.X / Same), (long)Math.Floor(place.Y / Same));

    /// <summary>Measures at points of the run; between two of them the distance is larger by less than a thousandth. The part that the run represents is tried
    /// first, then all parts that are cut.</summary>
    private double Error(in Segment run, in Segment drawn)
    {
        var (places, largest) = (run.Kind == SegmentKind.Line ? MinPlaces : Math.Max(MinPlaces, (int)Math.Abs(2.0 * run.Arc.Sweep.Degrees)), 0.0);
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
