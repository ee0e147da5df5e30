using Engraver.Core.Geometry;
using Engraver.Core.Verification.Corners;

namespace Engraver.Core.Verification;

/// <summary>Records machine positions during a run. The number of stored places is limited for any length of run: when there are too many, two neighbours are
/// merged to the one with the larger deviation, with the larger following error of both, so that the largest errors of a run are never lost.</summary>
/// <remarks>Not thread safe.</remarks>
public sealed class RunTraceBuilder
{
    /// <summary>Default limit of places, about 2 MB in the file.</summary>
    public const int MaxPlaces = 40_000;

    /// <summary>Time between the places that represent a span of constant speed, seconds.</summary>
    private const double SpanStepSeconds = 0.01;

    private const int MaxStepsOfSpan = 500;

    private readonly SegmentIndex _index;
    private readonly DrawnCorners? _corners;
    private readonly string _drawing;
    private readonly int _most;
    private readonly List<RunTracePlace> _places = [];
    private int _together = 1;
    private int _waiting;
    private RunTracePlace _worst;

    /// <param name="drawing">The drawing to cut, millimetres.</param>
    /// <param name="most">Maximum number of stored places, at least 4.</param>
    /// <param name="rounding">Tolerances with a corner tolerance, if corners may be rounded: the deviation is then the distance from the drawing or from the
    /// region of a corner.</param>
    public RunTraceBuilder(IReadOnlyList<Segment> drawing, int most = MaxPlaces, TraceTolerances? rounding = null)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(most, 4);
        _drawing = DrawnFingerprint.Of(drawing);
        Segment[] pieces = [.. CurvePieces.Split(drawing)];
        _index = new SegmentIndex(pieces);
        _corners = rounding is null ? null : DrawnCorners.Of(pieces, rounding);
        _most = most;
    }

    /// <summary>Conditions of the places that are added from now on.</summary>
    public TraceConditions Conditions { get; set; }

    /// <summary>Adds a machine position.</summary>
    public void Add(in TraceSample sample)
    {
        var deviation = 0.0;
        if (sample.Cutting && _index.NearEnoughTo(sample.Place, MergeTolerance(sample), out var distance) >= 0) deviation = DeviationAt(sample.Place, distance);
        Add(new RunTracePlace(sample.Seconds, sample.Place, sample.Cutting, deviation, sample.FollowingMm) { Conditions = Conditions });
    }

    private double DeviationAt(Point2D place, double distance) => _corners is not null && _corners.NearestTo(place, distance, 0.0, out var fromCorner) >= 0 ? fromCorner : distance;

    /// <summary>A place with a deviation up to this value is not stored, whatever its exact value: of the places that are merged, another one deviates
    /// more.</summary>
    private double MergeTolerance(in TraceSample sample) => _waiting > 0 && _worst.ToolOn == sample.Cutting ? Math.BitDecrement(_worst.DeviationMm) : -1.0;

    /// <summary>Adds a span that the machine moved along.</summary>
    public void Add(in TraceSpan span)
    {
        var steps = (int)Math.Clamp(Math.Ceiling((span.ToSeconds - span.FromSeconds) / SpanStepSeconds), 1.0, MaxStepsOfSpan);
        for (var i = 0; i <= steps; i++) Add(span.At((double)i / steps));
    }

    /// <summary>The stored trace.</summary>
    /// <param name="source">"record" or "polled".</param>
    public RunTrace ToTrace(string source) => new(source, _waiting == 0 ? [.. _places] : [.. _places, _worst]) { Drawing = _drawing };

    private void Add(in RunTracePlace place)
    {
        var following = _waiting == 0 ? place.FollowingMm : Larger(place.FollowingMm, _worst.FollowingMm);
        if (_waiting == 0 || place.DeviationMm >= _worst.DeviationMm || place.ToolOn != _worst.ToolOn) _worst = place;
        _worst = _worst with { FollowingMm = following };
        if (++_waiting < _together) return;
        _places.Add(_worst);
        _waiting = 0;
        if (_places.Count >= _most) Thin();
    }

    private void Thin()
    {
        var kept = 0;
        for (var i = 0; i + 1 < _places.Count; i += 2) _places[kept++] = Worse(_places[i], _places[i + 1]);
        if (_places.Count % 2 == 1) _places[kept++] = _places[^1];
        _places.RemoveRange(kept, _places.Count - kept);
        _together *= 2;
    }

    private static RunTracePlace Worse(in RunTracePlace one, in RunTracePlace other) => (one.DeviationMm > other.DeviationMm ? one : other) with { FollowingMm = Larger(one.FollowingMm, other.FollowingMm) };

    private static double? Larger(double? one, double? other) => one is { } known && other is { } also ? Math.Max(known, also) : one ?? other;
}
