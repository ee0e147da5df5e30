using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Starts, tabs and leads of the closed strokes of a profile.</summary>
internal sealed class ProfileDressing
{
    private readonly OrderedOperation _ordered;
    private readonly PartClearance _parts;
    private readonly double _radius;
    private readonly PickedPlaces _starts;
    private readonly PickedPlaces _tabsByHand;
    private readonly Dictionary<int, (double In, double Out)> _leads = [];
    private readonly Dictionary<int, TabPlaces> _tabs = [];
    private readonly HashSet<int> _withoutCorner = [];

    private ProfileDressing(OrderedOperation ordered, PartClearance parts)
    {
        (_ordered, _parts, _radius) = (ordered, parts, (ordered.Shape.Part.Tool.Diameter / 2.0) + ordered.Shape.Operation.Stock);
        var segments = ordered.Strokes.Select(stroke => (IReadOnlyList<Segment>)[.. stroke.Closed ? MovesOf(stroke).Select(move => move.Segment) : []]).ToList();
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
            var shortened = _leads.Where(lead => !refused.Contains(lead.Key) && (lead.Value.In < wanted.In || lead.Value.Out < wanted.Out)).Select(lead => lead.Key).ToList();
            if (refused.Count > 0) yield return At(OperationRules.NoLead, refused);
            if (shortened.Count > 0) yield return At(OperationRules.LeadShortened, shortened);
            if (_tabs.Where(tabs => tabs.Value.Missing > 0).Select(tabs => tabs.Key).ToList() is { Count: > 0 } fewer) yield return At(OperationRules.FewerTabs, fewer);
            if (_withoutCorner.Count > 0) yield return At(OperationRules.NoCorner, [.. _withoutCorner]);
            if (UnusedStarts is { Count: > 0 } starts) yield return At(OperationRules.StartUnused, starts);
            List<Point2D> tabs = [.. _tabsByHand.Unused, .. _tabs.Values.SelectMany(tabs => tabs.Unplaced)];
            if (tabs.Count > 0) yield return At(OperationRules.TabUnplaced, tabs);
        }
    }

    /// <summary>The middles of its tabs, and the picked starts that no contour uses: of several on a contour the last one is used.</summary>
    public DressedPlaces Places => new(Operation.Id, [.. _tabs.OrderBy(tabs => tabs.Key).SelectMany(tabs => tabs.Value.Points)], UnusedStarts);

    private IReadOnlyList<Point2D> UnusedStarts => [.. _starts.Unused, .. Enumerable.Range(0, _ordered.Strokes.Count).SelectMany(stroke => _starts.Of(stroke).SkipLast(1))];

    /// <summary>Null for an operation without any of these.</summary>
    public static ProfileDressing? For(OrderedOperation ordered, PartClearance parts) =>
        ordered.Shape.Operation is { Kind: OperationKind.Profile } and ({ LeadIn: not null } or { LeadOut: not null } or { Tabs: not null } or { Start: not StartRule.Nearest } or { StartAt.Count: > 0 }) ? new ProfileDressing(ordered, parts) : null;

    /// <summary>True when a stroke that was appended begins or ends beside its contour.</summary>
    public bool HasLeads(int stroke) => _leads.GetValueOrDefault(stroke) is { In: > 0.0 } or { Out: > 0.0 };

    /// <summary>Appends a pass of a closed stroke.</summary>
    /// <returns>False for an open stroke, of which nothing is appended.</returns>
    public bool Append(EntityTable table, int index, double depth)
    {
        var stroke = _ordered.Strokes[index];
        if (!stroke.Closed) return false;
        var dressed = new DressedStroke(Started(index, [.. MovesOf(stroke)]));
        dressed.SetDepth(depth);
        if (Operation is { Tabs: { } tabs, Depth: { } bottom })
        {
            var span = tabs.Width + _ordered.Shape.Part.Tool.Diameter;
            _tabs[index] = new TabPlaces(tabs, [.. dressed.Moves.Select(move => move.Segment)], _tabsByHand.Of(index), span);
            dressed.AddTabs(_tabs[index].Middles, span, depth, bottom - tabs.Height);
        }

        if (Operation.LeadIn is not null || Operation.LeadOut is not null) _leads[index] = dressed.AddLeads(Operation.LeadIn, Operation.LeadOut, _parts.At, _radius);
        foreach (var move in dressed.Moves) Append(table, move);
        return true;
    }

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
