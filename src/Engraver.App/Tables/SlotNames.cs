using System.Globalization;
using Engraver.App.Texts;
using Engraver.Core.EntityTables;

namespace Engraver.App.Tables;

/// <summary>Names and units of the 16 slots.</summary>
public static class SlotNames
{
    public static IReadOnlyList<string> All => [.. Enumerable.Range(0, EntitySlot.Count).Select(NameOf)];

    /// <summary>The name of one slot.</summary>
    public static string NameOf(int slot) => Text.Get("Slot." + slot.ToString(CultureInfo.InvariantCulture));

    /// <summary>Empty for a slot that is a count or a kind.</summary>
    public static IReadOnlyList<string> Units => [.. Enumerable.Range(0, EntitySlot.Count).Select(UnitOf)];

    /// <summary>The unit of one slot; empty for none.</summary>
    public static string UnitOf(int slot) => slot switch
    {
        >= EntitySlot.StartX and <= EntitySlot.Radius => Text.Get("SlotUnit.Length"),
        EntitySlot.StartAngle or EntitySlot.EndAngle or EntitySlot.Sweep => Text.Get("SlotUnit.Angle"),
        _ => "",
    };
}
