using System.Globalization;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>Checks a profile against what the controller accepts, before anything is generated from it.</summary>
public static class MachineProfileValidation
{
    /// <summary>Stands for a text that is no letter.</summary>
    internal const char NoLetter = '?';

    private const double LongestSettleSeconds = 600.0;

    /// <summary>One error for each setting that cannot be used, naming the setting, its value and the limit; empty for a usable profile.</summary>
    public static IReadOnlyList<Diagnostic> Check(MachineProfile profile, MachineLimits limits) => [.. Findings(profile, limits)];

    /// <summary>Whether the machine can cut at this feed; with a scale of 0 it is not the feed that is wrong.</summary>
    public static bool IsFeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) => !profile.Axes.All.All(axis => IsScale(axis.CountsPerMillimetre)) || IsSpeed(mmPerMinute, profile, limits);

    /// <summary>The feeds of this machine, mm/min, as text: what its slower axis resolves to what its finer axis can count.</summary>
    public static string FeedRange(MachineProfile profile, MachineLimits limits) =>
        string.Create(CultureInfo.InvariantCulture, $"{60.0 * limits.SlowestSpeed / profile.Scale.Smallest:0.######} to {60.0 * limits.FastestSpeed / profile.Scale.Largest:0.######}");

    private static IEnumerable<Diagnostic> Findings(MachineProfile p, MachineLimits limits)
    {
        const string Scale = "a number other than 0, negative to mirror the axis";
        if (!IsScale(p.Axes.X.CountsPerMillimetre)) yield return Finding("countsPerMillimetreX", p.Axes.X.CountsPerMillimetre, Scale);
        if (!IsScale(p.Axes.Y.CountsPerMillimetre)) yield return Finding("countsPerMillimetreY", p.Axes.Y.CountsPerMillimetre, Scale);
        if (!limits.Axes.Contains(p.Axes.X.Letter)) yield return Finding("axisX", p.Axes.X.Letter, $"one of the letters {limits.Axes}");
        if (!limits.Axes.Contains(p.Axes.Y.Letter)) yield return Finding("axisY", p.Axes.Y.Letter, $"one of the letters {limits.Axes}");
        else if (p.Axes.Y.Letter == p.Axes.X.Letter) yield return Finding("axisY", p.Axes.Y.Letter, "another axis than axisX");
        if (!IsSpeed(p.FeedMmPerMinute, p, limits)) yield return Finding("feedMmPerMinute", p.FeedMmPerMinute, AxisSpeeds(limits));
        if (!IsSpeed(p.RapidMmPerMinute, p, limits)) yield return Finding("rapidMmPerMinute", p.RapidMmPerMinute, AxisSpeeds(limits));
        if (!IsAcceleration(p.AccelerationCounts, limits)) yield return Finding("accelerationCounts", p.AccelerationCounts, Accelerations(limits));
        if (p.SharpCornerDegrees is not (>= 0.0 and <= 180.0)) yield return Finding("sharpCornerDegrees", p.SharpCornerDegrees, "0 to 180 degrees");
        if (p.ToolOutput < 1 || p.ToolOutput > limits.Outputs) yield return Finding("toolOutput", p.ToolOutput, $"an output from 1 to {limits.Outputs}");
        if (p.ToolSettleSeconds is not (>= 0.0 and <= LongestSettleSeconds)) yield return Finding("toolSettleSeconds", p.ToolSettleSeconds, $"0 to {LongestSettleSeconds} seconds");
        if (p.AngleQuantumDegrees is not (> 0.0 and <= 1.0)) yield return Finding("angleQuantumDegrees", p.AngleQuantumDegrees, "above 0 and at most 1 degree");
    }

    private static bool IsScale(double countsPerMillimetre) => double.IsFinite(countsPerMillimetre) && countsPerMillimetre != 0.0;

    private static bool IsSpeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) =>
        profile.Axes.All.All(axis => IsSpeed(mmPerMinute / 60.0 * Math.Abs(axis.CountsPerMillimetre), limits));

    private static bool IsSpeed(double countsPerSecond, MachineLimits limits) => countsPerSecond >= limits.SlowestSpeed && countsPerSecond <= limits.FastestSpeed;

    private static bool IsAcceleration(int counts, MachineLimits limits) =>
        counts >= limits.AccelerationStep && counts <= limits.LargestAcceleration && counts % limits.AccelerationStep == 0;

    private static string AxisSpeeds(MachineLimits limits) =>
        string.Create(CultureInfo.InvariantCulture, $"a speed of {limits.SlowestSpeed} to {limits.FastestSpeed} counts/s on each axis (mm/min times counts per mm over 60)");

    private static string Accelerations(MachineLimits limits) => string.Create(
        CultureInfo.InvariantCulture, $"a multiple of {limits.AccelerationStep} from {limits.AccelerationStep} to {limits.LargestAcceleration} counts/s2, which the controller would otherwise round down");

    private static Diagnostic Finding(string setting, double value, string limit) =>
        MotionRules.SettingOutOfRange.At(default, setting, value.ToString("R", CultureInfo.InvariantCulture), limit);

    private static Diagnostic Finding(string setting, char letter, string limit) => MotionRules.SettingOutOfRange.At(default, setting, letter == NoLetter ? "not one letter" : letter.ToString(), limit);
}
