using System.Globalization;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines.Profiles;

/// <summary>Settings of a profile that are each valid but together are probably not intended: the machine runs, but slower, or less far, than its owner
/// expects.</summary>
internal static class ProfileContradictions
{
    /// <summary>Warnings about a profile whose values have passed the check.</summary>
    public static IEnumerable<Diagnostic> Find(MachineProfile profile) => [.. Speeds(profile), .. Places(profile)];

    private static IEnumerable<Diagnostic> Speeds(MachineProfile p)
    {
        if (p.RapidMmPerMinute < p.FeedMmPerMinute) yield return Finding("rapidMmPerMinute", p.RapidMmPerMinute, "ProfileContradictions.RapidBelowFeed", p.FeedMmPerMinute);
        if (p.JogMmPerMinute > p.RapidMmPerMinute) yield return Finding("jogMmPerMinute", p.JogMmPerMinute, "ProfileContradictions.AboveRapid", p.RapidMmPerMinute);
        if (p.Height is { } height && height.PlungeMmPerMinute > p.RapidMmPerMinute) yield return Finding("plungeMmPerMinute", height.PlungeMmPerMinute, "ProfileContradictions.AboveRapid", p.RapidMmPerMinute);
    }

    private static IEnumerable<Diagnostic> Places(MachineProfile p)
    {
        foreach (var (name, axis, park) in new[] { ("X", p.Axes.X, p.ParkX), ("Y", p.Axes.Y, p.ParkY) })
        {
            if (park is { } place && axis.Travel is { } travel && (place < travel.Min || place > travel.Max)) yield return Finding("park" + name, place, "ProfileContradictions.ParkOutside", "travel" + name, travel.Min, travel.Max);
        }

        if (p.Height is { } height && p.Axes.Z is { Travel: { } way } && way.Max - way.Min < height.ClearanceHeight + height.CutDepth)
            yield return Finding("clearanceHeight", height.ClearanceHeight, "ProfileContradictions.TravelTooShort", height.CutDepth, way.Min, way.Max);
    }

    private static Diagnostic Finding(string setting, double value, string other, params object[] facts) =>
        MotionRules.ProfileContradiction.At(default, setting, value.ToString("R", CultureInfo.InvariantCulture), Wording.Get(other, facts));
}
