using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification.Corners;

namespace Engraver.Core.Verification;

/// <summary>The judge of a machine whose tool is moved by an axis: every cutting sample is compared with the drawing in X, Y and Z, and every part of the
/// drawing must be cut at its depth.</summary>
/// <remarks>
/// The drawing is cut below its heights by the depth in the machine profile; a pass before the last one runs higher by a whole multiple of the depth of a pass,
/// which is correct but does not reach the final depth. While the tool moves straight up or down at one place, it may be at any height above the drawing there,
/// and not below it. A corner is rounded at the height of its sides. Not thread safe.
/// </remarks>
public sealed class HeightJudge : ITraceJudge
{
    private readonly double? _depthPerPass;
    private readonly TraceTolerances _tolerances;
    private readonly DrawnPieces _pieces;
    private readonly SegmentIndex _index;
    private readonly DrawnCorners _corners;
    private readonly CornerCover _rounded;
    private readonly BoxTree.Measure _measureCorner;
    private readonly BoxTree.Measure _measure;
    private readonly CoveredParts[] _covered;
    private readonly bool _hasUpright;
    private Vector3D _asked;
    private bool _isVertical;
    private bool _wasRaised;
    private Point2D? _found;
    private TraceSample? _last;
    private (int Piece, Vector3D Place) _followed = (-1, default);
    private long _samples;
    private double _largest;
    private double _largestAtCorner;
    private double _extra;
    private TraceSample? _worst;

    /// <param name="drawing">The drawing to cut, millimetres, with its heights; order and direction are irrelevant.</param>
    /// <param name="tolerances">Tolerances based on the count of the coarsest of the three axes.</param>
    /// <param name="cutDepth">Cutting depth below the drawn heights, millimetres.</param>
    /// <param name="depthPerPass">Millimetres between two passes; null for one pass.</param>
    public HeightJudge(IReadOnlyList<StrokeMove> drawing, double cutDepth, double? depthPerPass, TraceTolerances tolerances)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        (_depthPerPass, _tolerances) = (depthPerPass, tolerances);
        _pieces = DrawnPieces.Create(drawing, cutDepth);
        _index = new SegmentIndex(_pieces.Plan);
        _covered = [.. _pieces.Plan.Select(_ => new CoveredParts())];
        _corners = DrawnCorners.Of(_pieces.Plan, tolerances, (piece, isStart) => isStart ? _pieces.From[piece] : _pieces.To[piece]);
        _measureCorner = MeasureCorner;
        _rounded = new CornerCover(_pieces.Plan, _corners, tolerances.Coverage, _covered, corner => Math.Abs(HeightAbove(SideBeside(corner), withPasses: false)) <= tolerances.Coverage);
        _hasUpright = Enumerable.Range(0, _pieces.Plan.Length).Any(_pieces.IsUpright);
        _measure = (piece, _) => Measure(piece).Distance;
    }

    public void Add(in TraceSample sample)
    {
        if (sample.Cutting && !IsFirstRaise(sample)) Judge(sample);
        else _followed = (-1, default);
        _wasRaised |= !sample.Cutting;
        _last = sample;
    }

    public void BeginRun() => (_wasRaised, _found, _last, _followed) = (false, null, null, (-1, default));

    /// <summary>True until the tool is up for the first time, at its initial place: it is raised from its initial position, on or in the work.</summary>
    private bool IsFirstRaise(in TraceSample sample)
    {
        _found ??= sample.Place;
        return !_wasRaised && sample.Place == _found;
    }

    /// <summary>A span is judged by its ends and places a step apart; a machine with a tool axis is evaluated sample by sample.</summary>
    public void Add(in TraceSpan span)
    {
        var largest = span.Path.Kind is SegmentKind.Arc or SegmentKind.Circle ? Math.Min(_tolerances.LargestStep, Math.Sqrt(8.0 * span.Path.Arc.Radius * _tolerances.ChordSagitta)) : _tolerances.LargestStep;
        var steps = Math.Max(1, (int)Math.Min(span.Samples - 1, Math.Ceiling(span.Path.Length / largest)));
        for (var i = 0; i <= steps; i++) Add(span.At((double)i / steps));
    }

    public TraceVerdict Verdict()
    {
        var (missing, first) = (0.0, (Point2D?)null);
        for (var piece = 0; piece < _covered.Length; piece++)
        {
            var length = _pieces.LengthOf(piece);
            var shortest = length / _tolerances.StepsFor(length);
            foreach (var (from, to) in _covered[piece].Gaps().Where(gap => (gap.To - gap.From) * length >= shortest * 0.999)) AddMissing(piece, from, to, ref missing, ref first);
        }

        return new TraceVerdict(_samples, _largest, _worst, missing, first, _extra) { CornerDeviation = _corners.IsUsed ? _largestAtCorner : null };
    }

    private void Judge(in TraceSample sample)
    {
        _samples++;
        _asked = new Vector3D(sample.XMm, sample.YMm, sample.ZMm);
        _isVertical = _last is { } before && (before.Place == sample.Place || !before.Cutting); // when polled, the first sample of a plunge can be the only one
        var nearest = Nearest(out var distance);
        var deviation = distance;
        if (distance > Math.Min(_largest, _tolerances.Coverage) && _corners.NearestBy(_measureCorner, sample.Place, distance, 0.0, out var fromCorner) is >= 0 and var corner)
        {
            (nearest, deviation) = (SideBeside(_corners[corner]), fromCorner);
            if (deviation <= _tolerances.Deviation) _largestAtCorner = Math.Max(_largestAtCorner, distance);
        }

        if (_worst is null || deviation > _largest) (_largest, _worst) = (deviation, sample);
        if (deviation > _tolerances.Coverage && _last is { Cutting: true } last) _extra += double.Hypot(last.Place.DistanceTo(sample.Place), last.ZMm - sample.ZMm);
        if (_isVertical && UprightAt(_asked) is { } upright) nearest = upright;
        if (nearest >= 0 && deviation <= _tolerances.Coverage && Measure(nearest) is { IsAtDepth: true } found) Follow(nearest, found.Foot);
        else if (_isVertical && AtDepth() is { } level) Follow(level.Piece, level.Foot);
        else _followed = (-1, default);
    }

    /// <summary>Distance of the queried place from the region of a corner at the height of the side beside it.</summary>
    private double MeasureCorner(int corner, Point2D place)
    {
        var inPlan = _corners[corner].DistanceTo(place);
        if (double.IsInfinity(inPlan)) return inPlan;
        var above = HeightAbove(SideBeside(_corners[corner]), withPasses: true);
        return double.Hypot(inPlan, _isVertical ? Math.Min(above, 0.0) : above);
    }

    /// <summary>The piece of a side of a corner beside the queried place.</summary>
    private int SideBeside(DrawnCorner corner)
    {
        var side = corner.IsAtFirst(new Point2D(_asked.X, _asked.Y)) ? corner.First : corner.Second;
        return side.Pieces.Length == 1 ? side.Pieces[0] : side.Pieces.MinBy(piece => _pieces.DistanceInPlan(piece, _asked));
    }

    /// <summary>Height of the queried place above a piece, or above the same piece in an earlier pass.</summary>
    private double HeightAbove(int piece, bool withPasses) => _asked.Z - _pieces.HeightOver(piece, _asked) - (withPasses ? PassesOver(piece) : 0.0);

    /// <summary>The piece straight up or down at a place: a peck, the side of a tab. Elsewhere the tool may rise freely, which cuts nothing.</summary>
    private int? UprightAt(Vector3D place)
    {
        if (!_hasUpright) return null;
        var piece = _index.NearestBy((piece, _) => _pieces.IsUpright(piece) ? _pieces.Nearest(piece, place).Distance : double.PositiveInfinity, new Point2D(place.X, place.Y), _tolerances.Coverage, 0.0, out var distance);
        return piece >= 0 && distance <= _tolerances.Coverage ? piece : null;
    }

    /// <summary>A piece at whose height the tool is while it moves straight down, where deeper pieces, which it is above, are as near; null for none.</summary>
    private (int Piece, double Foot)? AtDepth()
    {
        _isVertical = false;
        var piece = _index.NearestBy(_measure, new Point2D(_asked.X, _asked.Y), _tolerances.Coverage, 0.0, out var distance);
        var level = piece >= 0 && distance <= _tolerances.Coverage && Measure(piece) is { IsAtDepth: true } found ? (piece, found.Foot) : ((int Piece, double Foot)?)null;
        _isVertical = true;
        return level;
    }

    /// <summary>The last piece is tried first: samples are consecutive.</summary>
    private int Nearest(out double deviation)
    {
        deviation = double.PositiveInfinity;
        var last = _followed.Piece;
        if (last >= 0)
        {
            deviation = Measure(last).Distance;
            if (deviation <= Math.Min(_largest, _tolerances.Deviation)) return last;
        }

        var nearest = _index.NearestBy(_measure, new Point2D(_asked.X, _asked.Y), deviation, 0.0, out var distance);
        if (nearest < 0) return last;
        deviation = distance;
        return nearest;
    }

    private void Follow(int piece, double foot)
    {
        if (_followed is { Piece: >= 0 } before)
        {
            CoverBetween(before, (piece, _asked));
            _rounded.AddChord(new Point2D(before.Place.X, before.Place.Y), new Point2D(_asked.X, _asked.Y), piece);
        }
        else
        {
            Cover(piece, foot, foot);
        }

        _followed = (piece, _asked);
    }

    /// <summary>From one place to the other the tool moved straight along the piece that it follows; when the piece changes, to the end of the first and from
    /// the start of the second, and along the pieces between them.</summary>
    private void CoverBetween((int Piece, Vector3D Place) from, (int Piece, Vector3D Place) to)
    {
        var middle = (from.Place + to.Place) * 0.5;
        if (from.Piece != to.Piece && !_isVertical && (to.Place - from.Place).Length > _tolerances.Coverage && PieceAt(middle) is { } between)
        {
            CoverBetween(from, (between, middle));
            CoverBetween((between, middle), to);
            return;
        }

        if (from.Piece != to.Piece) Cover(from.Piece, FootAt(from.Piece, from.Place), FootAt(from.Piece, to.Place));
        Cover(to.Piece, FootAt(to.Piece, from.Place), FootAt(to.Piece, to.Place));
    }

    /// <summary>The piece followed at a place between two samples; null for none.</summary>
    private int? PieceAt(Vector3D place)
    {
        var asked = _asked;
        _asked = place;
        var piece = _index.NearestBy(_measure, new Point2D(place.X, place.Y), _tolerances.Coverage, 0.0, out _);
        var isFollowed = piece >= 0 && Measure(piece) is { IsAtDepth: true } found && found.Distance <= _tolerances.Coverage;
        _asked = asked;
        return isFollowed ? piece : null;
    }

    private void Cover(int piece, double from, double to)
    {
        var (low, high) = (Math.Min(from, to), Math.Max(from, to));
        if (_pieces.Plan[piece].Kind == SegmentKind.Circle && high - low > 0.5)
        {
            _covered[piece].Add(0.0, low);
            _covered[piece].Add(high, 1.0);
            return;
        }

        _covered[piece].Add(low, high);
    }

    private double FootAt(int piece, Vector3D place) => _pieces.Nearest(piece, place).Foot;

    /// <summary>Distance of the queried place from a piece, or from the same piece in an earlier pass.</summary>
    private (double Foot, double Distance, bool IsAtDepth) Measure(int piece)
    {
        var passes = PassesOver(piece);
        var (foot, distance) = _pieces.Nearest(piece, _asked with { Z = _asked.Z - passes });
        if (!_isVertical) return (foot, distance, passes == 0.0);
        var (below, inPlan) = (Math.Max(0.0, _pieces.HeightOver(piece, _asked) - _asked.Z), _pieces.DistanceInPlan(piece, _asked));
        return Math.Min(distance, double.Hypot(inPlan, below)) is var free && free < distance ? (foot, free, false) : (foot, distance, passes == 0.0);
    }

    /// <summary>Height of the pass of the queried place above the last pass of a piece.</summary>
    private double PassesOver(int piece) => _depthPerPass is { } step ? Math.Max(0.0, Math.Round((_asked.Z - _pieces.HeightOver(piece, _asked)) / step)) * step : 0.0;

    /// <summary>A gap does not count where another piece of the drawing that coincides with this one was cut.</summary>
    private void AddMissing(int piece, double from, double to, ref double missing, ref Point2D? first)
    {
        var length = _pieces.LengthOf(piece);
        var parts = Math.Max(1, (int)Math.Min(10_000.0, Math.Ceiling((to - from) * length / _tolerances.LargestStep)));
        for (var i = 0; i < parts; i++)
        {
            var middle = from + ((to - from) * (i + 0.5) / parts);
            var place = _pieces.PlaceAt(piece, middle);
            var plan = new Point2D(place.X, place.Y);
            if (_index.NearestBy((other, _) => other == piece ? double.PositiveInfinity : DistanceToCut(other, place), plan, 2.0 * _tolerances.Coverage, 0.0, out var distance) >= 0 && distance <= 2.0 * _tolerances.Coverage) continue;
            missing += (to - from) * length / parts;
            first ??= plan;
        }
    }

    /// <summary>Due to rounding, the extreme ends of a piece can be outside the part that was cut.</summary>
    private double DistanceToCut(int piece, Vector3D place)
    {
        var (foot, _) = _pieces.Nearest(piece, place);
        return _covered[piece].Parts().Select(part => (_pieces.PlaceAt(piece, Math.Clamp(foot, part.From, part.To)) - place).Length).DefaultIfEmpty(double.PositiveInfinity).Min();
    }
}

/// <summary>A drawing in three coordinates: lines that can rise, and level arcs and pieces of curves; millimetres, at the depth at which they are
/// cut.</summary>
/// <param name="Plan">Ellipses and splines as their pieces.</param>
/// <param name="From">Height at the start of each.</param>
/// <param name="To">Height at the end of each.</param>
internal sealed record DrawnPieces(Segment[] Plan, double[] From, double[] To)
{
    public static DrawnPieces Create(IReadOnlyList<StrokeMove> drawing, double depth)
    {
        var (plan, from, to) = (new List<Segment>(drawing.Count), new List<double>(drawing.Count), new List<double>(drawing.Count));
        foreach (var move in drawing)
        {
            foreach (var piece in CurvePieces.Split([move.Segment]))
            {
                plan.Add(piece);
                from.Add(move.StartZ - depth);
                to.Add(move.EndZ - depth);
            }
        }

        return new DrawnPieces([.. plan], [.. from], [.. to]);
    }

    public bool IsUpright(int piece) => From[piece] != To[piece] && Plan[piece].Length == 0.0;

    /// <summary>Length in plan; of a piece straight up or down its height.</summary>
    public double LengthOf(int piece) => Plan[piece].Length is > 0.0 and var inPlan ? inPlan : Math.Abs(To[piece] - From[piece]);

    /// <summary>Point of a piece nearest to a place, as a fraction, and its distance.</summary>
    public (double Foot, double Distance) Nearest(int piece, Vector3D place)
    {
        ref readonly var segment = ref Plan[piece];
        if (segment.Kind == SegmentKind.Line && From[piece] != To[piece])
        {
            var way = new Vector3D(segment.End.X - segment.Start.X, segment.End.Y - segment.Start.Y, To[piece] - From[piece]);
            var spoke = place - new Vector3D(segment.Start.X, segment.Start.Y, From[piece]);
            var foot = Math.Clamp(spoke.Dot(way) / way.Dot(way), 0.0, 1.0);
            return (foot, (spoke - (way * foot)).Length);
        }

        var (level, inPlan) = PerpendicularFoot.Place(segment, new Point2D(place.X, place.Y), double.NaN);
        return (level, double.Hypot(inPlan, place.Z - From[piece]));
    }

    public double DistanceInPlan(int piece, Vector3D place) => PerpendicularFoot.Place(Plan[piece], new Point2D(place.X, place.Y), double.NaN).Distance;

    /// <summary>Height of a piece where it is nearest in plan.</summary>
    public double HeightOver(int piece, Vector3D place) => From[piece] == To[piece] ? From[piece] : From[piece] + ((To[piece] - From[piece]) * PerpendicularFoot.Place(Plan[piece], new Point2D(place.X, place.Y), double.NaN).Foot);

    public Vector3D PlaceAt(int piece, double fraction) => Plan[piece].PointAt(fraction) is var plan ? new Vector3D(plan.X, plan.Y, From[piece] + ((To[piece] - From[piece]) * fraction)) : default;
}
