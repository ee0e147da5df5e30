using System.Globalization;
using Engraver.App.Texts;
using Engraver.Core.EntityTables;

namespace Engraver.App.Tables;

/// <summary>What the 16 slots are called.</summary>
public static class SlotNames
{
    public static IReadOnlyList<string> All { get; } = [.. Enumerable.Range(0, EntitySlot.Count).Select(slot => Text.Of("Slot." + slot.ToString(CultureInfo.InvariantCulture)))];
}
