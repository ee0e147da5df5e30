using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Starts, descents, tabs, overcuts and leads of the strokes of an operation.</summary>
internal sealed class StrokeDressing
{
    private const double Rounding = 1e-6;

    private readonly OrderedOperation _ordered;
    private readonly PartClearance _parts;
    private readonly double _radius;
    private readonly double _maxErrorMm;
    private readonly StrokeLead _lead;
    private readonly RampEntry? _ramp;
    private readonly HelixEntry? _helix;
    private readonly double _helixReach;
    private readonly double _rampBelowTabs;
    private readonly PickedPlaces _starts;
    private readonly PickedPlaces _tabsByHand;
    private readonly Dictionary<int, (double In, double Out)> _leads = [];
    private readonly Dictionary<int, TabPlaces> _tabs = [];
    private readonly HashSet<int> _withoutCorner = [];
    private readonly HashSet<int> _withoutRamp = [];
    private readonly HashSet<int> _withoutHelix = [];
    private readonly HashSet<int> _shorterThanOvercut = [];

    private StrokeDressing(OrderedOperation ordered, PartClearance parts, double maxErrorMm)
    {
        (_ordered, _parts, _maxErrorMm, _radius) = (ordered, parts, maxErrorMm, (ordered.Shape.Part.Tool.Diameter / 2.0) + ordered.Shape.Operation.Stock);
        _lead = new StrokeLead(parts.At, _radius, maxErrorMm + Rounding);
        _ramp = Operation.RampDegrees is { } angle ? new RampEntry(angle, maxErrorMm) : null;
        _helix = _ramp is { } slope && Operation.HelixRadius is { } turn ? new HelixEntry(slope, turn, parts.At, _radius, maxErrorMm) : null;
        _helixReach = Operation.HelixReachOf(ordered.Shape.Part.Tool);
        _rampBelowTabs = Operation is { Tabs: { } tabs, Depth: { } bottom } ? DepthSteps(Operation).Where(step => step.Depth > bottom - tabs.Height).Select(step => _ramp?.LengthOf(step.Depth - Math.Max(step.Before, bottom - tabs.Height!.Value)) ?? 0.0).DefaultIfEmpty().Max() : 0.0;
        var segments = ordered.Strokes.Select(stroke => (IReadOnlyList<Segment>)[.. IsClosedProfile(stroke) ? MovesOf(stroke).Select(move => move.Segment) : []]).ToList();
        _starts = new PickedPlaces(segments, Operation.StartAt, Operation.StartWithin);
        _tabsByHand = new PickedPlaces(segments, Operation.Tabs?.At ?? [], Operation.Tabs?.Within ?? 0.0);
    }

    private Operation Operation => _ordered.Shape.Operation;

    /// <summary>What there was not enough room for, one finding for each kind.</summary>
    public IEnumerable<Diagnostic> Findings
    {
        get
        {
            var wanted = (In: Operation.LeadIn?.Length ?? 0.0, Out: Operation.LeadOut?.Length ?? 0.0);
            var refused = _leads.Where(lead => (wanted.In > 0.0 && lead.Value.In == 0.0) || (wanted.Out > 0.0 && lead.Value.Out == 0.0)).Select(lead => lead.Key).ToList();
            var shortened = _leads.Where(lead => !refused.Contains(lead.Key) && (lead.Value.In < wanted.In - Rounding || lead.Value.Out < wanted.Out - Rounding)).Select(lead => lead.Key).ToList();
            if (refused.Count > 0) yield return At(OperationRules.NoLead, refused);
            if (shortened.Count > 0) yield return At(OperationRules.LeadShortened, shortened);
            if (_tabs.Where(tabs => tabs.Value.Missing > 0).Select(tabs => tabs.Key).ToList() is { Count: > 0 } fewer) yield return At(OperationRules.FewerTabs, fewer);
            if (_withoutCorner.Count > 0) yield return At(OperationRules.NoCorner, [.. _withoutCorner]);
            if (_shorterThanOvercut.Count > 0) yield return At(OperationRules.OvercutShortened, [.. _shorterThanOvercut]);
            if (_withoutRamp.Count > 0) yield return At(OperationRules.NoRamp, [.. _withoutRamp]);
            if (_withoutHelix.Count > 0) yield return At(OperationRules.NoHelix, [.. _withoutHelix]);
            if (UnusedStarts is { Count: > 0 } starts) yield return At(OperationRules.StartUnused, starts);
            List<Point2D> tabs = [.. _tabsByHand.Unused, .. _tabs.Values.SelectMany(tabs => tabs.Unplaced)];
            if (tabs.Count > 0) yield return At(OperationRules.TabUnplaced, tabs);
        }
    }

    /// <summary>The middles of its tabs, and the picked starts that no contour uses: of several on a contour the last one is used.</summary>
    public DressedPlaces Places => new(Operation.Id, [.. _tabs.OrderBy(tabs => tabs.Key).SelectMany(tabs => tabs.Value.Points)], UnusedStarts);

    private IReadOnlyList<Point2D> UnusedStarts => [.. _starts.Unused, .. Enumerable.Range(0, _ordered.Strokes.Count).SelectMany(stroke => _starts.Of(stroke).SkipLast(1))];

    /// <summary>Null for an operation without any of these.</summary>
    public static StrokeDressing? For(OrderedOperation ordered, PartClearance parts, double maxErrorMm) =>
        ordered.Shape.Operation is { RampDegrees: not null } or { LeadIn: not null } or { LeadOut: not null } or { Tabs: not null } or { Start: not StartRule.Nearest } or { StartAt.Count: > 0 } or { Overcut: > 0.0 }
            ? new StrokeDressing(ordered, parts, maxErrorMm)
            : null;

    /// <summary>Depth of each pass, and the depth before it.</summary>
    public static IEnumerable<(double Before, double Depth)> DepthSteps(Operation operation) => operation.PassDepths().Prepend(operation.StartDepth).Zip(operation.PassDepths());

    /// <summary>Appends a pass of a stroke.</summary>
    /// <returns>The strokes that it is cut as: several where gaps are left for tabs.</returns>
    public IReadOnlyList<DressedPiece> Append(EntityTable table, int index, double before, double depth)
    {
        var stroke = _ordered.Strokes[index];
        return Operation.Kind == OperationKind.Profile ? AppendProfile(table, index, before, depth) : [AppendDescended(table, index, stroke, before, depth)];
    }

    /// <summary>The rows of the stroke after a descent.</summary>
    private DressedPiece AppendDescended(EntityTable table, int index, OrderedStroke stroke, double before, double depth)
    {
        IReadOnlyList<StrokeMove> moves = [.. MovesOf(stroke)];
        var (first, descent) = (table.Count, HelixTo(index, moves[0], before, depth) ?? DescentTo(index, moves, before, depth));
        foreach (var move in descent) Append(table, move);
        for (var row = stroke.FirstRow; row < stroke.FirstRow + stroke.Rows; row++) OperationRows.Append(table, _ordered.Path, row, -depth, -depth);
        return new DressedPiece(table.Count - first, stroke.Closed && descent.Count == 0);
    }

    private IReadOnlyList<DressedPiece> AppendProfile(EntityTable table, int index, double before, double depth)
    {
        var isClosed = _ordered.Strokes[index].Closed;
        IReadOnlyList<StrokeMove> contour = [.. MovesOf(_ordered.Strokes[index])];
        if (isClosed) contour = Started(index, contour);
        var dressed = new DressedStroke(contour, depth);
        var overcut = isClosed ? OvercutOf(index, contour) : 0.0;
        if (isClosed && Operation.Tabs is { } tabs) AddTabs(dressed, tabs, index, contour, overcut, depth);
        dressed.AddOvercut(overcut);
        var helix = HelixTo(index, LeadInto(dressed.Moves[0]) ?? dressed.Moves[0], before, depth);
        var descent = helix ?? DescentTo(index, contour, before, depth);
        if (helix is null) dressed.Enter(descent);
        var hasLeads = AddLeads(dressed, index, isInSlot: helix is null && descent.Count > 0 && before > Operation.StartDepth);
        if (helix is not null) dressed.Enter(helix);
        var pieces = PiecesOf(dressed.Moves);
        foreach (var move in pieces.SelectMany(piece => piece)) Append(table, move);
        return [.. pieces.Select(piece => new DressedPiece(piece.Count, isClosed && !hasLeads && overcut == 0.0 && descent.Count == 0 && pieces.Count == 1))];
    }

    private void AddTabs(DressedStroke dressed, PartTabs tabs, int index, IReadOnlyList<StrokeMove> contour, double overcut, double depth)
    {
        var (span, slope) = (tabs.Width + _ordered.Shape.Part.Tool.Diameter, tabs.Slope);
        _tabs[index] = new TabPlaces(tabs, [.. contour.Select(move => move.Segment)], _tabsByHand.Of(index), span + (2.0 * (tabs.Height ?? 0.0) / slope), Math.Max(overcut, _helixReach), Math.Max(_rampBelowTabs, _helixReach));
        var top = Operation.Depth is { } bottom ? bottom - tabs.Height!.Value : depth;
        if (top < depth || tabs.Height is null) dressed.AddTabs(_tabs[index].Middles, span, top, slope, _maxErrorMm);
    }

    private double OvercutOf(int index, IReadOnlyList<StrokeMove> contour)
    {
        var length = contour.Sum(move => move.Segment.Length);
        if (Operation.Overcut > length) _shorterThanOvercut.Add(index);
        return Math.Min(Operation.Overcut, length);
    }

    /// <param name="isInSlot">A ramp begins in the slot that the pass before has cut: beside it there is material, and no lead.</param>
    private bool AddLeads(DressedStroke dressed, int index, bool isInSlot)
    {
        if (Operation is { LeadIn: null, LeadOut: null }) return false;
        var into = isInSlot ? null : LeadInto(dressed.Moves[0]);
        var outOf = Operation.LeadOut is { } leadOut ? _lead.OutOf(leadOut, dressed.Moves[^1]) : null;
        if (into is { } first) dressed.Enter([first]);
        if (outOf is { } last) dressed.Leave([last]);
        var (knownIn, knownOut) = _leads.GetValueOrDefault(index, (double.PositiveInfinity, double.PositiveInfinity));
        _leads[index] = (isInSlot ? knownIn : Math.Min(knownIn, Of(into)), Math.Min(knownOut, Of(outOf)));
        return into is not null || outOf is not null;

        static double Of(StrokeMove? lead) => lead is { } move ? StrokeLead.LengthOf(move.Segment) : 0.0;
    }

    private StrokeMove? LeadInto(in StrokeMove first) => Operation.LeadIn is { } lead ? _lead.Into(lead, first) : null;

    /// <summary>Null for an operation without a helix, and where none has room.</summary>
    private IReadOnlyList<StrokeMove>? HelixTo(int index, in StrokeMove first, double before, double depth)
    {
        if (_helix is null) return null;
        if (_helix.To(first, before, depth) is { } helix) return helix;
        _withoutHelix.Add(index);
        return null;
    }

    private IReadOnlyList<StrokeMove> DescentTo(int index, IReadOnlyList<StrokeMove> stroke, double before, double depth)
    {
        if (_ramp is null) return [];
        if (_ramp.To(stroke, _ordered.Strokes[index].Closed, before, depth) is { } descent) return descent;
        _withoutRamp.Add(index);
        return [];
    }

    /// <summary>The strokes of a tool without an axis are divided at the tabs.</summary>
    private List<List<StrokeMove>> PiecesOf(IReadOnlyList<StrokeMove> moves)
    {
        if (Operation.Tabs is not { Height: null }) return [[.. moves]];
        var pieces = new List<List<StrokeMove>> { new() };
        foreach (var move in moves)
        {
            if (move.Role != StrokeRole.Tab) pieces[^1].Add(move);
            else if (pieces[^1].Count > 0) pieces.Add([]);
        }

        return pieces;
    }

    private bool IsClosedProfile(OrderedStroke stroke) => Operation.Kind == OperationKind.Profile && stroke.Closed;

    private IEnumerable<StrokeMove> MovesOf(OrderedStroke stroke) => Enumerable.Range(stroke.FirstRow, stroke.Rows).Select(row => StrokeMove.From(_ordered.Path[row]));

    /// <summary>From the picked place of the stroke, or by the rule.</summary>
    private IReadOnlyList<StrokeMove> Started(int index, IReadOnlyList<StrokeMove> moves)
    {
        if (_starts.Of(index).TakeLast(1).ToList() is [var picked]) return StrokeStart.Near(picked, moves);
        if (StrokeStart.By(Operation.Start, moves, _parts.At, _radius) is { } started) return started;
        _withoutCorner.Add(index);
        return moves;
    }

    private static void Append(EntityTable table, in StrokeMove move)
    {
        var slots = OperationRows.AtHeight(EntitySlots.Of(move.Segment, 0.0), move.StartZ, move.EndZ);
        slots[EntitySlot.SequenceNumber] = table.Count + 1;
        slots[EntitySlot.Role] = (int)move.Role;
        table.Append(slots, move.EntityIndex, null);
    }

    private Diagnostic At(DiagnosticRule rule, List<int> strokes)
    {
        var place = _ordered.Path[_ordered.Strokes[strokes.Min()].FirstRow].StartPoint;
        return rule.At(default, Operation.Title, FactText.Of(strokes.Count), FactText.Of(place.X), FactText.Of(place.Y)) with { Place = place };
    }

    private Diagnostic At(DiagnosticRule rule, IReadOnlyList<Point2D> places) =>
        rule.At(default, Operation.Title, FactText.Of(places.Count), FactText.Of(places[0].X), FactText.Of(places[0].Y)) with { Place = places[0] };
}

/// <summary>A stroke that was appended.</summary>
/// <param name="Rows">Number of its rows.</param>
/// <param name="Closed">True when it ends where it starts.</param>
internal readonly record struct DressedPiece(int Rows, bool Closed);
