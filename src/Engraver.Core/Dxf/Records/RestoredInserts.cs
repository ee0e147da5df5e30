using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Records;

/// <summary>The inserts of curves that were written one by one (SAVEAS), from their extended data: for each insert, the outermost first, the name of its block,
/// a number and the insertion point.</summary>
internal static class RestoredInserts
{
    /// <summary>Name of the application of the extended data.</summary>
    public const string Application = "CNCENGRAVER";

    /// <summary>First text of the extended data of a curve that comes from inserts.</summary>
    public const string Mark = "INSERT";

    private const int Name = 1000;
    private const int NumberCode = 1071;
    private const int X = 1011;

    /// <summary>The inserts that a record states; empty for a record without them.</summary>
    public static IEnumerable<(string Block, int Number, Vector3D Position)> Of(EntityRecord record)
    {
        if (record.Own is not [{ Code: Name, Text: Mark }, .. var values]) yield break;
        for (var i = 0; i + 4 < values.Count; i += 5)
        {
            if (values[i].Code != Name || values[i + 1].Code != NumberCode || values[i + 2].Code != X) yield break;
            yield return (values[i].Text, (int)values[i + 1].Number, new Vector3D(values[i + 2].Number, values[i + 3].Number, values[i + 4].Number));
        }
    }
}
