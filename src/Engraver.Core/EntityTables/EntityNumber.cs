using System.Globalization;

namespace Engraver.Core.EntityTables;

/// <summary>How a cell is spelled: whole numbers without a decimal point, everything else so that it reads back to the same double; never "-0".</summary>
internal static class EntityNumber
{
    public static string Format(double value) => value == 0.0 ? "0" : value.ToString("R", CultureInfo.InvariantCulture);
}
