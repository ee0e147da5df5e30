using System.Globalization;

namespace Engraver.App.Texts;

/// <summary>A duration as an operator reads it.</summary>
public static class ClockText
{
    /// <summary>41 seconds is <c>00:41</c>, two hours and a half <c>2:30:00</c>.</summary>
    public static string Format(double seconds)
    {
        var time = TimeSpan.FromSeconds(Math.Clamp(seconds, 0.0, 1e9));
        return time.TotalHours < 1.0
            ? time.ToString(@"mm\:ss", CultureInfo.InvariantCulture)
            : string.Create(CultureInfo.InvariantCulture, $"{(long)time.TotalHours}:{time:mm\\:ss}");
    }

    /// <summary>The same with decimals of the seconds: 41.25 seconds with one decimal is <c>00:41.3</c>.</summary>
    public static string Format(double seconds, int decimals)
    {
        if (decimals <= 0) return Format(seconds);
        var (rounded, unit) = (Math.Round(Math.Clamp(seconds, 0.0, 1e9), decimals, MidpointRounding.AwayFromZero), Math.Pow(10.0, -decimals));
        var whole = Math.Floor(rounded + (unit / 2.0));
        return Format(whole) + Math.Max(0.0, rounded - whole).ToString("." + new string('0', decimals), CultureInfo.InvariantCulture);
    }
}
