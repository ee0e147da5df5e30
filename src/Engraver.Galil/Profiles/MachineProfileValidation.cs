using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Galil.Language;

namespace Engraver.Galil.Profiles;

/// <summary>Checks a profile against what the controller accepts (galil-dmc.md F.5), before anything is generated from it.</summary>
public static class MachineProfileValidation
{
    private const double LongestSettleSeconds = 600.0;

    private static string AxisSpeeds { get; } = $"a speed of {DmcLimits.SlowestSpeed} to {DmcLimits.FastestSpeed} counts/s on each axis (mm/min times counts per mm over 60)";

    private static string Accelerations { get; } =
        $"a multiple of {DmcLimits.AccelerationStep} from {DmcLimits.AccelerationStep} to {DmcLimits.LargestAcceleration} counts/s2, which the controller would otherwise round down";

    /// <summary>One error for each setting that cannot be used, naming the setting, its value and the limit; empty for a usable profile.</summary>
    public static IReadOnlyList<Diagnostic> Check(MachineProfile profile) => [.. Findings(profile)];

    /// <summary>Whether the machine can cut at this feed; with a scale of 0 it is not the feed that is wrong.</summary>
    public static bool IsFeed(double mmPerMinute, MachineProfile profile) => !IsScale(profile.CountsPerMillimetreX) || !IsScale(profile.CountsPerMillimetreY) || IsSpeed(mmPerMinute, profile);

    /// <summary>The feeds of this machine, mm/min, as text: what its slower axis resolves to what its finer axis can count.</summary>
    public static string FeedRange(MachineProfile profile)
    {
        var (x, y) = (Math.Abs(profile.CountsPerMillimetreX), Math.Abs(profile.CountsPerMillimetreY));
        return string.Create(CultureInfo.InvariantCulture, $"{60.0 * DmcLimits.SlowestSpeed / Math.Min(x, y):0.######} to {60.0 * DmcLimits.FastestSpeed / Math.Max(x, y):0.######}");
    }

    private static IEnumerable<Diagnostic> Findings(MachineProfile p)
    {
        const string Scale = "a number other than 0, negative to mirror the axis";
        if (!IsScale(p.CountsPerMillimetreX)) yield return Finding("countsPerMillimetreX", p.CountsPerMillimetreX, Scale);
        if (!IsScale(p.CountsPerMillimetreY)) yield return Finding("countsPerMillimetreY", p.CountsPerMillimetreY, Scale);
        if (!IsSpeed(p.FeedMmPerMinute, p)) yield return Finding("feedMmPerMinute", p.FeedMmPerMinute, AxisSpeeds);
        if (!IsSpeed(p.RapidMmPerMinute, p)) yield return Finding("rapidMmPerMinute", p.RapidMmPerMinute, AxisSpeeds);
        if (!IsAcceleration(p.AccelerationCounts)) yield return Finding("accelerationCounts", p.AccelerationCounts, Accelerations);
        if (p.SharpCornerDegrees is not (>= 0.0 and <= 180.0)) yield return Finding("sharpCornerDegrees", p.SharpCornerDegrees, "0 to 180 degrees");
        if (p.ToolOutput is < 1 or > DmcLimits.Outputs) yield return Finding("toolOutput", p.ToolOutput, $"an output from 1 to {DmcLimits.Outputs}");
        if (p.ToolSettleSeconds is not (>= 0.0 and <= LongestSettleSeconds)) yield return Finding("toolSettleSeconds", p.ToolSettleSeconds, $"0 to {LongestSettleSeconds} seconds");
        if (p.AngleQuantumDegrees is not (> 0.0 and <= 1.0)) yield return Finding("angleQuantumDegrees", p.AngleQuantumDegrees, "above 0 and at most 1 degree");
    }

    private static bool IsScale(double countsPerMillimetre) => double.IsFinite(countsPerMillimetre) && countsPerMillimetre != 0.0;

    private static bool IsSpeed(double mmPerMinute, MachineProfile profile) =>
        IsSpeed(mmPerMinute / 60.0 * Math.Abs(profile.CountsPerMillimetreX)) && IsSpeed(mmPerMinute / 60.0 * Math.Abs(profile.CountsPerMillimetreY));

    private static bool IsSpeed(double countsPerSecond) => countsPerSecond is >= DmcLimits.SlowestSpeed and <= DmcLimits.FastestSpeed;

    private static bool IsAcceleration(int counts) =>
        counts is >= DmcLimits.AccelerationStep and <= DmcLimits.LargestAcceleration && counts % DmcLimits.AccelerationStep == 0;

    private static Diagnostic Finding(string setting, double value, string limit) =>
        MotionRules.SettingOutOfRange.At(default, setting, value.ToString("R", CultureInfo.InvariantCulture), limit);
}
