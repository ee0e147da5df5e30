using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Machines;

/// <summary>Checks a profile against what the controller accepts, before anything is generated from it.</summary>
public static class MachineProfileValidation
{
    private const double LongestSettleSeconds = 600.0;

    /// <summary>One error for each setting that cannot be used, naming the setting, its value and the limit; empty for a usable profile.</summary>
    public static IReadOnlyList<Diagnostic> Check(MachineProfile profile, MachineLimits limits) => [.. Findings(profile, limits)];

    /// <summary>Whether the machine can cut at this feed; with a scale of 0 it is not the feed that is wrong.</summary>
    public static bool IsFeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) => !IsScale(profile.CountsPerMillimetreX) || !IsScale(profile.CountsPerMillimetreY) || IsSpeed(mmPerMinute, profile, limits);

    /// <summary>The feeds of this machine, mm/min, as text: what its slower axis resolves to what its finer axis can count.</summary>
    public static string FeedRange(MachineProfile profile, MachineLimits limits) =>
        string.Create(CultureInfo.InvariantCulture, $"{60.0 * limits.SlowestSpeed / profile.Scale.Smallest:0.######} to {60.0 * limits.FastestSpeed / profile.Scale.Largest:0.######}");

    private static IEnumerable<Diagnostic> Findings(MachineProfile p, MachineLimits limits)
    {
        const string Scale = "a number other than 0, negative to mirror the axis";
        if (!IsScale(p.CountsPerMillimetreX)) yield return Finding("countsPerMillimetreX", p.CountsPerMillimetreX, Scale);
        if (!IsScale(p.CountsPerMillimetreY)) yield return Finding("countsPerMillimetreY", p.CountsPerMillimetreY, Scale);
        if (!IsSpeed(p.FeedMmPerMinute, p, limits)) yield return Finding("feedMmPerMinute", p.FeedMmPerMinute, AxisSpeeds(limits));
        if (!IsSpeed(p.RapidMmPerMinute, p, limits)) yield return Finding("rapidMmPerMinute", p.RapidMmPerMinute, AxisSpeeds(limits));
        if (!IsAcceleration(p.AccelerationCounts, limits)) yield return Finding("accelerationCounts", p.AccelerationCounts, Accelerations(limits));
        if (p.SharpCornerDegrees is not (>= 0.0 and <= 180.0)) yield return Finding("sharpCornerDegrees", p.SharpCornerDegrees, "0 to 180 degrees");
        if (p.ToolOutput < 1 || p.ToolOutput > limits.Outputs) yield return Finding("toolOutput", p.ToolOutput, $"an output from 1 to {limits.Outputs}");
        if (p.ToolSettleSeconds is not (>= 0.0 and <= LongestSettleSeconds)) yield return Finding("toolSettleSeconds", p.ToolSettleSeconds, $"0 to {LongestSettleSeconds} seconds");
        if (p.Park is { } park && (IsScale(p.CountsPerMillimetreX) && IsScale(p.CountsPerMillimetreY)) && !p.Scale.Holds(Bounds2D.FromCorners(park, park), default)) yield return Finding("parkX", park.X, "a place that the controller can count to");
        if (p.ParkX is null != p.ParkY is null) yield return Finding(p.ParkX is null ? "parkY" : "parkX", p.ParkX ?? p.ParkY ?? 0.0, "given together with the other one: a park position has two");
        if (p.AngleQuantumDegrees is not (> 0.0 and <= 1.0)) yield return Finding("angleQuantumDegrees", p.AngleQuantumDegrees, "above 0 and at most 1 degree");
    }

    private static bool IsScale(double countsPerMillimetre) => double.IsFinite(countsPerMillimetre) && countsPerMillimetre != 0.0;

    private static bool IsSpeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) =>
        IsSpeed(mmPerMinute / 60.0 * Math.Abs(profile.CountsPerMillimetreX), limits) && IsSpeed(mmPerMinute / 60.0 * Math.Abs(profile.CountsPerMillimetreY), limits);

    private static bool IsSpeed(double countsPerSecond, MachineLimits limits) => countsPerSecond >= limits.SlowestSpeed && countsPerSecond <= limits.FastestSpeed;

    private static bool IsAcceleration(int counts, MachineLimits limits) =>
        counts >= limits.AccelerationStep && counts <= limits.LargestAcceleration && counts % limits.AccelerationStep == 0;

    private static string AxisSpeeds(MachineLimits limits) =>
        string.Create(CultureInfo.InvariantCulture, $"a speed of {limits.SlowestSpeed} to {limits.FastestSpeed} counts/s on each axis (mm/min times counts per mm over 60)");

    private static string Accelerations(MachineLimits limits) => string.Create(
        CultureInfo.InvariantCulture, $"a multiple of {limits.AccelerationStep} from {limits.AccelerationStep} to {limits.LargestAcceleration} counts/s2, which the controller would otherwise round down");

    private static Diagnostic Finding(string setting, double value, string limit) =>
        MotionRules.SettingOutOfRange.At(default, setting, value.ToString("R", CultureInfo.InvariantCulture), limit);
}
