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
}
