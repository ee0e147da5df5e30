using System.Globalization;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>The density that the desktop has set in the server's resources ("Xft.dpi: 144").</summary>
internal static class XftDpi
{
    /// <returns>Pixels for each device independent unit (1/96 inch); 1 when there is no usable value.</returns>
    public static double ScaleOf(string? resources)
    {
        foreach (var line in (resources ?? "").Split('\n'))
        {
            var colon = line.IndexOf(':', StringComparison.Ordinal);
            if (colon < 0 || !line.AsSpan(0, colon).Trim().SequenceEqual("Xft.dpi")) continue;
            if (double.TryParse(line.AsSpan(colon + 1).Trim(), NumberStyles.Float, CultureInfo.InvariantCulture, out var dpi) && dpi is >= 48 and <= 768) return dpi / 96;
        }

        return 1.0;
    }
}
