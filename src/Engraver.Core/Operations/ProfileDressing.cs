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
    private readonly Dictionary<int, (double In, double Out)> _leads = [];
    private readonly Dictionary<int, int> _tabs = [];

    private ProfileDressing(OrderedOperation ordered, PartClearance parts) =>
        (_ordered, _parts, _radius) = (ordered, parts, (ordered.Shape.Part.Tool.Diameter / 2.0) + ordered.Shape.Operation.Stock);

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
            if (_tabs.Where(tabs => tabs.Value < Operation.Tabs!.Count).Select(tabs => tabs.Key).ToList() is { Count: > 0 } fewer) yield return At(OperationRules.FewerTabs, fewer);
        }
    }

    /// <summary>Null for an operation without any of these.</summary>
    public static ProfileDressing? For(OrderedOperation ordered, PartClearance parts) =>
        ordered.Shape.Operation is { Kind: OperationKind.Profile } and ({ LeadIn: not null } or { LeadOut: not null } or { Tabs: not null } or { Start: not StartRule.Nearest }) ? new ProfileDressing(ordered, parts) : null;

    /// <summary>True when a stroke that was appended begins or ends beside its contour.</summary>
    public bool HasLeads(int stroke) => _leads.GetValueOrDefault(stroke) is { In: > 0.0 } or { Out: > 0.0 };

    /// <summary>Appends a pass of a closed stroke.</summary>
    /// <returns>False for an open stroke, of which nothing is appended.</returns>
    public bool Append(EntityTable table, int index, double depth)
    {
        var stroke = _ordered.Strokes[index];
        if (!stroke.Closed) return false;
        var dressed = new DressedStroke([.. Enumerable.Range(stroke.FirstRow, stroke.Rows).Select(row => StrokeMove.From(_ordered.Path[row]))]);
        dressed.StartBy(Operation.Start);
        dressed.SetDepth(depth);
        if (Operation is { Tabs: { } tabs, Depth: { } bottom }) _tabs[index] = dressed.AddTabs(tabs.Count, tabs.Width + _ordered.Shape.Part.Tool.Diameter, depth, bottom - tabs.Height);
        if (Operation.LeadIn is not null || Operation.LeadOut is not null) _leads[index] = dressed.AddLeads(Operation.LeadIn, Operation.LeadOut, _parts.At, _radius);
        foreach (var move in dressed.Moves) Append(table, move);
        return true;
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
}
