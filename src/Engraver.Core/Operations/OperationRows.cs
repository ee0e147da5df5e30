using Engraver.Core.EntityTables;

namespace Engraver.Core.Operations;

/// <summary>Rows of a path at the depth of a pass.</summary>
internal static class OperationRows
{
    /// <summary>The same row with heights at its ends and its centre.</summary>
    public static EntitySlots AtHeight(EntitySlots slots, double start, double end)
    {
        (slots[EntitySlot.StartZ], slots[EntitySlot.EndZ]) = (start, end);
        if (slots[EntitySlot.Radius] != 0.0) slots[EntitySlot.CentreZ] = start;
        return slots;
    }

    /// <summary>Appends a row of a path at the height of a pass.</summary>
    public static void Append(EntityTable table, EntityTable path, int row, double start, double end)
    {
        var slots = AtHeight(path.CopySlots(row), start, end);
        slots[EntitySlot.SequenceNumber] = table.Count + 1;
        table.Append(slots, path.EntityIndexOf(row), path.CurveOf(row));
    }
}
