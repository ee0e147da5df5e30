using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf;

/// <summary>The content of a file apart from the curves, texts and points of its drawing.</summary>
public static class UnusedContent
{
    /// <summary>Model-space records that did not become a curve, text or point, by type: construction, refused records; points beyond those that are kept, also
    /// in blocks. Empty when nothing would be lost.</summary>
    public static IReadOnlyList<(string Type, int Count)> Find(Drawing drawing)
    {
        var rest = new SortedDictionary<string, int>(StringComparer.Ordinal);
        var cut = Enumerable.Range(0, drawing.Entities.Count).Select(index => drawing.Entities[index].Type).Distinct().Select(type => type.ToDxfName()).ToHashSet(StringComparer.Ordinal);
        foreach (var (type, count) in drawing.Balance.EntityCounts)
        {
            var kind = RecordKinds.Find(type);
            if (kind is RecordKind.Construction or RecordKind.AttributeDefinition || (RecordKinds.IsOutline(kind) && !cut.Contains(type))) rest[type] = count;
        }

        if (drawing.Balance.Points - drawing.PointsRead is > 0 and var lost) rest["POINT"] = lost;
        foreach (var refused in drawing.Balance.Refused) rest[refused.Type] = rest.GetValueOrDefault(refused.Type) + 1;
        return [.. rest.Select(pair => (pair.Key, pair.Value))];
    }
}
