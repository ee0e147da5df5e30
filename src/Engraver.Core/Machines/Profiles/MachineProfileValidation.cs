using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Profiles;

/// <summary>Checks a profile against what the controller accepts, before anything is generated from it.</summary>
public static class MachineProfileValidation
{
    /// <summary>Represents a text that is not a letter.</summary>
    internal const char NoLetter = '?';

    private const double LongestSettleSeconds = 600.0;
    private const double FastestSpindle = 1e6;

    private const double LargestRate = 1e9;

    private const double LargestFollowingErrorMm = 1000.0;

    /// <summary>One error for each setting that cannot be used, naming the setting, its value and the limit; empty for a usable profile.</summary>
    public static IReadOnlyList<Diagnostic> Check(MachineProfile profile, MachineLimits limits) => [.. Findings(profile, limits)];

    /// <summary>Whether the machine can cut at this feed; true with a scale of 0, where the feed is not the error.</summary>
    public static bool IsFeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) => !profile.Axes.All.All(axis => axis.Scale.IsUsable) || IsSpeed(mmPerMinute, profile, limits);

    /// <summary>The feeds of this machine, mm/min, as text: from what its slower axis resolves to what its finer axis can count.</summary>
    public static string FeedRange(MachineProfile profile, MachineLimits limits) =>
        Wording.Get("MachineProfileValidation.FromTo", profile.Scale.Coarser.LengthOf(60.0 * limits.SlowestSpeed), profile.Scale.Finer.LengthOf(60.0 * limits.FastestSpeed));

    private static IEnumerable<Diagnostic> Findings(MachineProfile p, MachineLimits limits)
    {
        var scale = Wording.Get("MachineProfileValidation.ScaleNotZero");
        foreach (var (name, axis) in p.Axes.Named.Where(named => !named.Axis.Scale.IsUsable)) yield return Finding("countsPerMillimetre" + name, axis.CountsPerMillimetre, scale);
        foreach (var (name, axis) in p.Axes.Named)
        {
            if (!limits.Axes.Contains(axis.Letter)) yield return Finding("axis" + name, axis.Letter, Wording.Get("MachineProfileValidation.OneOfLetters", limits.Axes));
            else if (p.Axes.Named.TakeWhile(named => named.Name != name).FirstOrDefault(named => named.Axis.Letter == axis.Letter).Name is not '\0' and var same) yield return Finding("axis" + name, axis.Letter, Wording.Get("MachineProfileValidation.OtherAxisThan", "axis" + same));
        }

        if (!IsSpeed(p.FeedMmPerMinute, p, limits)) yield return Finding("feedMmPerMinute", p.FeedMmPerMinute, AxisSpeeds(limits));
        if (!IsSpeed(p.RapidMmPerMinute, p, limits)) yield return Finding("rapidMmPerMinute", p.RapidMmPerMinute, AxisSpeeds(limits));
        if (!IsAcceleration(p.AccelerationCounts, limits)) yield return Finding("accelerationCounts", p.AccelerationCounts, Accelerations(limits));
        foreach (var (field, acceleration) in new[] { ("accelerationX", p.AccelerationX), ("accelerationY", p.AccelerationY) })
        {
            if (acceleration is { } counts && !IsAcceleration(counts, limits)) yield return Finding(field, counts, Accelerations(limits));
        }

        if (p.FollowingErrorMm is not (null or (> 0.0 and <= LargestFollowingErrorMm))) yield return Finding("followingErrorMm", p.FollowingErrorMm.Value, Wording.Get("MachineProfileValidation.LengthUpTo", LargestFollowingErrorMm));
        if (p.ToolOutput < 1 || p.ToolOutput > limits.Outputs) yield return Finding("toolOutput", p.ToolOutput, Wording.Get("MachineProfileValidation.OutputFrom", limits.Outputs));
        if (p.ToolSettleSeconds is not (>= 0.0 and <= LongestSettleSeconds)) yield return Finding("toolSettleSeconds", p.ToolSettleSeconds, Wording.Get("MachineProfileValidation.Seconds", LongestSettleSeconds));
        foreach (var finding in ToolFindings(p, limits)) yield return finding;
        if (p.ParkX is null != p.ParkY is null) yield return Finding(p.ParkX is null ? "parkY" : "parkX", p.ParkX ?? p.ParkY ?? 0.0, Wording.Get("MachineProfileValidation.ParkNeedsBoth"));
        if (p.Park is { } park && !IsCountable(park, p)) yield return Finding("parkX", park.X, Wording.Get("MachineProfileValidation.PositionWithinCounters"));
        if (p.AngleQuantumDegrees is not (> 0.0 and <= 1.0)) yield return Finding("angleQuantumDegrees", p.AngleQuantumDegrees, Wording.Get("MachineProfileValidation.UpToOneDegree"));
        foreach (var (field, rate) in new[] { ("costPerHour", p.Rates?.PerHour), ("costPerMetre", p.Rates?.PerMetre), ("costPerStart", p.Rates?.PerStart) })
        {
            if (rate is not (null or (>= 0.0 and <= LargestRate))) yield return Finding(field, rate.Value, Wording.Get("MachineProfileValidation.Rate", LargestRate));
        }

        foreach (var finding in HandMoveValidation.Findings(p, limits)) yield return finding;
    }

    private static IEnumerable<Diagnostic> ToolFindings(MachineProfile p, MachineLimits limits)
    {
        if (p.ToolOffSettleSeconds is not (null or (>= 0.0 and <= LongestSettleSeconds))) yield return Finding("toolOffSettleSeconds", p.ToolOffSettleSeconds.Value, Wording.Get("MachineProfileValidation.Seconds", LongestSettleSeconds));
        foreach (var (name, axis) in p.Axes.Named.Where(named => named.Axis.MotorType is { } type && !limits.MotorTypes.Contains(type)))
            yield return Finding("motorType" + name, axis.MotorType!.Value, Wording.Get("MachineProfileValidation.OneOf", string.Join(", ", limits.MotorTypes.Select(NumberText.Exact))));
        if (p.Spindle is { } spindle)
        {
            if (spindle.Output < 1 || spindle.Output > limits.Outputs || (p.Height is null && spindle.Output == p.ToolOutput)) yield return Finding("spindleOutput", spindle.Output, Wording.Get("MachineProfileValidation.OtherOutputThanTool", limits.Outputs));
            if (spindle.SpinUpSeconds is not (>= 0.0 and <= LongestSettleSeconds)) yield return Finding("spindleSeconds", spindle.SpinUpSeconds, Wording.Get("MachineProfileValidation.Seconds", LongestSettleSeconds));
            if (spindle.SpeedAxis is { } letter && (!limits.Axes.Contains(letter) || p.Axes.Letters.Contains(letter))) yield return Finding("spindleAxis", letter, Wording.Get("MachineProfileValidation.FreeAxis", limits.Axes));
            if (spindle.FullSpeed is not (null or (> 0.0 and <= FastestSpindle))) yield return Finding("spindleFullSpeed", spindle.FullSpeed.Value, Wording.Get("MachineProfileValidation.TurnsPerMinute", FastestSpindle));
            if (!(Math.Abs(spindle.SpeedVolts) <= limits.LargestVolts)) yield return Finding("spindleVolts", spindle.SpeedVolts, Wording.Get("MachineProfileValidation.Volts", limits.LargestVolts));
        }

        if (p.Power is { } power)
        {
            if (!limits.Axes.Contains(power.Axis) || p.Axes.Letters.Contains(power.Axis) || p.Spindle?.SpeedAxis is not null) yield return Finding("powerAxis", power.Axis, Wording.Get(p.Spindle?.SpeedAxis is null ? "MachineProfileValidation.FreeAxis" : "MachineProfileValidation.NotWithSpindleAxis", limits.Axes));
            if (!(Math.Abs(power.Volts) <= limits.LargestVolts)) yield return Finding("powerVolts", power.Volts, Wording.Get("MachineProfileValidation.Volts", limits.LargestVolts));
            if (p.Height is not null) yield return Finding("powerAxis", power.Axis, Wording.Get("MachineProfileValidation.OnlyOutputTool"));
        }

        if (p.Height is not { } height) yield break;
        if (p.Axes.Z is not { } z)
        {
            yield return Finding("axisZ", NoLetter, Wording.Get("MachineProfileValidation.LetterForAxisDrive", limits.Axes));
            yield break;
        }

        if (!(height.ClearanceHeight >= height.RetractHeight)) yield return Finding("clearanceHeight", height.ClearanceHeight, Wording.Get("MachineProfileValidation.AtLeastRetractHeight", NumberText.Exact(height.RetractHeight)));
        if (!IsHeight(height.ClearanceHeight, p)) yield return Finding("clearanceHeight", height.ClearanceHeight, Wording.Get("MachineProfileValidation.HeightWithinCounters"));
        if (!(height.RetractHeight > 0.0)) yield return Finding("retractHeight", height.RetractHeight, Wording.Get("MachineProfileValidation.AboveWork"));
        if (!(height.CutDepth >= 0.0) || !IsHeight(height.CutDepth, p)) yield return Finding("cutDepth", height.CutDepth, Wording.Get("MachineProfileValidation.DepthNotNegative"));
        if (height.DepthPerPass is { } step && !(step > 0.0 && Math.Abs(z.Scale.Exact(step)) >= 1.0)) yield return Finding("depthPerPass", step, Wording.Get("MachineProfileValidation.AtLeastOneCount"));
        if (!IsSpeed(z.Scale.CountsOf(height.PlungeMmPerMinute / 60.0), limits)) yield return Finding("plungeMmPerMinute", height.PlungeMmPerMinute, AxisSpeeds(limits));
    }

    private static bool IsHeight(double millimetres, MachineProfile profile) => Math.Abs(profile.Scale.Z.Exact(millimetres)) < int.MaxValue / 4.0;

    private static bool IsCountable(Point2D place, MachineProfile profile) => !profile.Scale.X.IsUsable || !profile.Scale.Y.IsUsable || profile.Scale.IsInRange(Bounds2D.FromCorners(place, place), default);

    internal static bool IsSpeed(double mmPerMinute, MachineProfile profile, MachineLimits limits) =>
        profile.Axes.All.All(axis => IsSpeed(axis.Scale.CountsOf(mmPerMinute / 60.0), limits));

    internal static bool IsSpeed(double countsPerSecond, MachineLimits limits) => countsPerSecond >= limits.SlowestSpeed && countsPerSecond <= limits.FastestSpeed;

    private static bool IsAcceleration(int counts, MachineLimits limits) =>
        counts >= limits.AccelerationStep && counts <= limits.LargestAcceleration && counts % limits.AccelerationStep == 0;

    internal static string AxisSpeeds(MachineLimits limits) =>
        Wording.Get("MachineProfileValidation.SpeedInCounts", limits.SlowestSpeed, limits.FastestSpeed);

    private static string Accelerations(MachineLimits limits) => Wording.Get("MachineProfileValidation.AccelerationSteps", limits.AccelerationStep, limits.LargestAcceleration);

    internal static Diagnostic Finding(string setting, double value, string limit) =>
        MotionRules.SettingOutOfRange.At(default, setting, value.ToString("R", CultureInfo.InvariantCulture), limit);

    private static Diagnostic Finding(string setting, char letter, string limit) => MotionRules.SettingOutOfRange.At(default, setting, letter == NoLetter ? Wording.Get("MachineProfileValidation.NotOneLetter") : letter.ToString(), limit);
}
