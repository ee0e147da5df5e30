using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Converts strokes to vector sequences, one after the other.</summary>
internal sealed class StrokeGenerator
{
    /// <summary>Maximum number of halvings of an arc before it is cut as chords.</summary>
    private const int MaxHalvings = 8;

    private const double ShortestPiece = 8.0;

    private readonly CountsScale _scale;
    private readonly double _maxErrorMm;
    private readonly ArcCommandFit _arcFit;
    private readonly SequenceBuilder _builder;
    private readonly CornerDetector _corners;
    private readonly MachineProfile _profile;
    private double _lift;
    private CountsPoint _reached;
    private int _entity;
    private double? _slope;

    /// <param name="profile">The machine.</param>
    /// <param name="maxErrorMm">Largest distance of chords from an arc, millimetres.</param>
    /// <param name="style">How segments are grouped.</param>
    /// <param name="columns">Columns of the whole program; the strokes are appended to them.</param>
    public StrokeGenerator(MachineProfile profile, double maxErrorMm, MotionStyle style, VectorColumns columns)
    {
        _profile = profile;
        _scale = profile.Scale;
        _maxErrorMm = ArcChords.ErrorOf(maxErrorMm, _scale);
        _arcFit = new ArcCommandFit(new AngleQuantum(profile.AngleQuantumDegrees));
        _builder = new SequenceBuilder(profile.VectorSpeed(), new SlopeSpeed(profile), style, columns);
        _corners = new CornerDetector(profile, profile.VectorSpeed());
    }

    /// <summary>Appends a pass of the stroke, in counts.</summary>
    /// <param name="lift">Height of the pass above the depth of the stroke, millimetres; 0 for the last pass, and for a machine without a tool axis.</param>
    /// <param name="terms">How the tool is brought to the work and taken away.</param>
    /// <returns>False when the whole stroke is shorter than a count: nothing is appended.</returns>
    public bool Generate(ToolpathStroke stroke, double lift, StrokeTerms? terms)
    {
        var first = stroke.Moves[0];
        _lift = lift;
        _reached = Place(first.Segment.Start, first.StartZ);
        _slope = null;
        _corners.Begin();
        _builder.Begin(_reached);
        foreach (var move in stroke.Moves) Move(move);
        return _builder.Finish(stroke.Index, terms);
    }

    private void Move(in StrokeMove move)
    {
        var segment = move.Segment;
        var (from, to) = (Place(segment.Start, move.StartZ), Place(segment.End, move.EndZ));
        if (Vanishes(segment) && to.Z == _builder.Height)
        {
            _corners.Skip(segment);
            return;
        }

        _entity = move.EntityIndex;
        if (IsBentUpOrDown(move) | _corners.IsCornerBefore(segment)) _builder.EndSequence(); // no short circuit: both calls record the move
        BridgeGapTo(from);
        Cut(segment, from.Z, to);
        _reached = to;
        _corners.Cut(segment);
    }

    /// <summary>Where heights are cut, a change of slope is a corner like one in plan.</summary>
    private bool IsBentUpOrDown(in StrokeMove move)
    {
        if (_profile.Height is null) return false;
        var slope = Math.Atan2(move.EndZ - move.StartZ, move.Segment.Length) * (180.0 / Math.PI);
        var bend = _slope is { } before ? Math.Abs(slope - before) : 0.0;
        _slope = slope;
        return bend > _profile.SharpCornerDegrees;
    }

    private CountsPoint Place(Point2D millimetres, double z) => _scale.ToCounts(millimetres) with { Z = HeightOf(z, _profile, _lift) };

    /// <summary>The height at which the tool axis cuts, below the drawn height; on other machines heights are not cut.</summary>
    private static int HeightOf(double drawn, MachineProfile profile, double lift) => profile.Height is { } drive ? profile.Scale.ToHeight(drawn - drive.CutDepth + lift) : 0;

    /// <summary>True when the move is shorter than a count and does not add up to a count together with the previous ones.</summary>
    private bool Vanishes(in Segment segment) =>
        _scale.Finer.CountsOf(segment.Length) < 1.0 && _builder.Position.DistanceTo(_scale.Exact(segment.End)) < 1.0;

    /// <summary>Cuts across a gap within the join tolerance. Measured from the drawn end of the previous move, not from the predicted end of its arc.</summary>
    private void BridgeGapTo(CountsPoint start)
    {
        if (start != _reached) _builder.Line(start, _entity);
    }

    private void Cut(in Segment segment, int height, CountsPoint end)
    {
        if (segment.Kind == SegmentKind.Line)
        {
            _builder.Line(end, _entity);
        }
        else if (!_scale.IsUniform)
        {
            foreach (var vertex in ArcChords.Vertices(segment.Arc, _maxErrorMm)) _builder.Line(_scale.ToCounts(vertex) with { Z = height }, _entity);
        }
        else
        {
            Arc(_scale.Exact(segment.Arc), _scale.Exact(segment.End));
        }
    }

    private void Arc(ArcSegment wanted, Point2D trueEnd)
    {
        if (ArcCommandFit.CanHold(wanted.Radius)) LastPiece(wanted, trueEnd, MaxHalvings);
        else Chords(wanted);
    }

    /// <summary>The piece that ends at the end of the move: one CR; otherwise the arc is halved, and its second half is processed in the same way.</summary>
    private void LastPiece(ArcSegment wanted, Point2D trueEnd, int halvings)
    {
        var target = CountsScale.Round(trueEnd);
        if (_arcFit.ToEnd(_builder.Position, wanted, new Point2D(target.X, target.Y), trueEnd) is { } aimed)
        {
            _builder.Arc(aimed, _entity);
        }
        else if (CanHalve(wanted, halvings))
        {
            InnerPiece(FirstHalf(wanted), halvings - 1);
            LastPiece(SecondHalf(wanted), trueEnd, halvings - 1);
        }
        else
        {
            Chords(wanted);
        }
    }

    private void InnerPiece(ArcSegment wanted, int halvings)
    {
        if (_arcFit.ToMark(_builder.Position, wanted) is { } aimed)
        {
            _builder.Arc(aimed, _entity);
        }
        else if (CanHalve(wanted, halvings))
        {
            InnerPiece(FirstHalf(wanted), halvings - 1);
            InnerPiece(SecondHalf(wanted), halvings - 1);
        }
        else
        {
            Chords(wanted);
        }
    }

    private void Chords(ArcSegment wanted)
    {
        foreach (var vertex in ArcChords.Vertices(wanted, _scale.Finer.CountsOf(_maxErrorMm))) _builder.Line(CountsScale.Round(vertex) with { Z = _builder.Height }, _entity);
    }

    private static bool CanHalve(ArcSegment wanted, int halvings) => halvings > 0 && wanted.Length >= 2.0 * ShortestPiece;

    private static ArcSegment FirstHalf(ArcSegment arc) => arc with { Sweep = arc.Sweep * 0.5 };

    private static ArcSegment SecondHalf(ArcSegment arc) => arc with { Start = arc.Start + (arc.Sweep * 0.5), Sweep = arc.Sweep * 0.5 };
}
