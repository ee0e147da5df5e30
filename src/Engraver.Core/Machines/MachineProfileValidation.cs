using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

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
        Wording.Get("MachineProfileValidation.To", 60.0 * limits.SlowestSpeed / profile.Scale.Smallest, 60.0 * limits.FastestSpeed / profile.Scale.Largest);

    private static IEnumerable<Diagnostic> Findings(MachineProfile p, MachineLimits limits)
    {
        var scale = Wording.Get("MachineProfileValidation.NumberOtherThanNegative");
        if (!IsScale(p.Axes.X.CountsPerMillimetre)) yield return Finding("countsPerMillimetreX", p.Axes.X.CountsPerMillimetre, scale);
        if (!IsScale(p.Axes.Y.CountsPerMillimetre)) yield return Finding("countsPerMillimetreY", p.Axes.Y.CountsPerMillimetre, scale);
        if (!limits.Axes.Contains(p.Axes.X.Letter)) yield return Finding("axisX", p.Axes.X.Letter, Wording.Get("MachineProfileValidation.OneLetters", limits.Axes));
        if (!limits.Axes.Contains(p.Axes.Y.Letter)) yield return Finding("axisY", p.Axes.Y.Letter, Wording.Get("MachineProfileValidation.OneLetters", limits.Axes));
        else if (p.Axes.Y.Letter == p.Axes.X.Letter) yield return Finding("axisY", p.Axes.Y.Letter, Wording.Get("MachineProfileValidation.AnotherAxisThanAxisX"));
        if (!IsSpeed(p.FeedMmPerMinute, p, limits)) yield return Finding("feedMmPerMinute", p.FeedMmPerMinute, AxisSpeeds(limits));
        if (!IsSpeed(p.RapidMmPerMinute, p, limits)) yield return Finding("rapidMmPerMinute", p.RapidMmPerMinute, AxisSpeeds(limits));
        if (!IsAcceleration(p.AccelerationCounts, limits)) yield return Finding("accelerationCounts", p.AccelerationCounts, Accelerations(limits));
        if (p.SharpCornerDegrees is not (>= 0.0 and <= 180.0)) yield return Finding("sharpCornerDegrees", p.SharpCornerDegrees, Wording.Get("MachineProfileValidation.Degrees"));
        if (p.ToolOutput < 1 || p.ToolOutput > limits.Outputs) yield return Finding("toolOutput", p.ToolOutput, Wording.Get("MachineProfileValidation.OutputFrom", limits.Outputs));
        if (p.ToolSettleSeconds is not (>= 0.0 and <= LongestSettleSeconds)) yield return Finding("toolSettleSeconds", p.ToolSettleSeconds, Wording.Get("MachineProfileValidation.Seconds", LongestSettleSeconds));
        if (p.ParkX is null != p.ParkY is null) yield return Finding(p.ParkX is null ? "parkY" : "parkX", p.ParkX ?? p.ParkY ?? 0.0, Wording.Get("MachineProfileValidation.ParkHasTwo"));
        if (p.Park is { } park && !IsCountable(park, p)) yield return Finding("parkX", park.X, Wording.Get("MachineProfileValidation.ParkCountable"));
        if (p.AngleQuantumDegrees is not (> 0.0 and <= 1.0)) yield return Finding("angleQuantumDegrees", p.AngleQuantumDegrees, Wording.Get("MachineProfileValidation.AboveMostDegree"));
    }

    private static bool IsCountable(Point2D place, MachineProfile profile) => !IsScale(profile.Scale.X) || !IsScale(profile.Scale.Y) || profile.Scale.Holds(Bounds2D.FromCorners(place, place), default);

    private static bool IsScale(double countsPerMillimetre) => double.IsFinite(countsPerMillimetre) && countsPerMillimetre != 0.0;

    private static bool IsSpeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) =>
        profile.Axes.All.All(axis => IsSpeed(mmPerMinute / 60.0 * Math.Abs(axis.CountsPerMillimetre), limits));

    private static bool IsSpeed(double countsPerSecond, MachineLimits limits) => countsPerSecond >= limits.SlowestSpeed && countsPerSecond <= limits.FastestSpeed;

    private static bool IsAcceleration(int counts, MachineLimits limits) =>
        counts >= limits.AccelerationStep && counts <= limits.LargestAcceleration && counts % limits.AccelerationStep == 0;

    private static string AxisSpeeds(MachineLimits limits) =>
        Wording.Get("MachineProfileValidation.SpeedCountsOnEach", limits.SlowestSpeed, limits.FastestSpeed);

    private static string Accelerations(MachineLimits limits) => Wording.Get("MachineProfileValidation.MultipleFromCountsS2", limits.AccelerationStep, limits.LargestAcceleration);

    private static Diagnostic Finding(string setting, double value, string limit) =>
        MotionRules.SettingOutOfRange.At(default, setting, value.ToString("R", CultureInfo.InvariantCulture), limit);

    private static Diagnostic Finding(string setting, char letter, string limit) => MotionRules.SettingOutOfRange.At(default, setting, letter == NoLetter ? Wording.Get("MachineProfileValidation.NotOneLetter") : letter.ToString(), limit);
}
