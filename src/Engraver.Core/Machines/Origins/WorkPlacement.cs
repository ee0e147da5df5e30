using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines.Origins;

/// <summary>Finds where a job's drawing is on the machine, and refuses instead of guessing.</summary>
public static class WorkPlacement
{
    /// <param name="memory">What is stored of the machine.</param>
    /// <param name="place">The controller's present position.</param>
    /// <param name="start">The drawing point of the start option, counts of the drawing.</param>
    public static PlacementResult Find(StoredMachineState memory, ControllerPosition place, OriginRequest request, MachineProfile profile, CountsPoint start)
    {
        if (NotHomed(memory, place, profile) is { } unhomed) return Refused(unhomed);
        return request switch
        {
            OriginRequest.PresentPosition => Present(place, start),
            OriginRequest.MachinePoint { Machine: var at } => Given(memory, place, at, profile),
            OriginRequest.ActiveOrigin => Work(memory, place, profile, assumesZero: true),
            OriginRequest.NamedOrigin { Name: var name } => Work(memory with { Active = name }, place, profile, assumesZero: false) with { IsAssumed = memory.Origins.GetValueOrDefault(name) is { IsAssumed: true } },
            _ => throw new ArgumentOutOfRangeException(nameof(request)),
        };
    }

    /// <summary>The same placement, unless the job that is placed there leaves the machine's travel.</summary>
    /// <param name="dryRun">The tool stays out of the work.</param>
    /// <param name="following">What the jobs after it reach there; null for none.</param>
    public static PlacementResult Within(PlacementResult found, MotionProgram program, bool dryRun, StoredMachineState memory, ControllerPosition place, MotionExtents? following = null)
    {
        ArgumentNullException.ThrowIfNull(found);
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(memory);
        if (found.Frame is not { } frame || !memory.IsTravelKnown(program.Profile, place)) return found;
        return TravelLimits.Refusal(program.Profile, program, frame, dryRun, following) is { } outside ? found with { Frame = null, Refusal = outside } : found with { IsWithinTravel = true };
    }

    /// <summary>The same placement, unless a job that follows at another work origin has no place there, would leave the travel, or would be cut at the
    /// place of another one.</summary>
    /// <param name="own">How the job itself is placed.</param>
    /// <param name="profile">The machine with the depths of the jobs.</param>
    /// <param name="dryRun">The tool stays out of the work.</param>
    public static PlacementResult Followed(PlacementResult found, OriginRequest own, FollowingJobs following, MachineProfile profile, bool dryRun, StoredMachineState memory, ControllerPosition place)
    {
        ArgumentNullException.ThrowIfNull(found);
        ArgumentNullException.ThrowIfNull(following);
        ArgumentNullException.ThrowIfNull(memory);
        var taken = new Dictionary<(long X, long Y), string>();
        if (found is { Frame: { } at, IsAssumed: false } && own is OriginRequest.NamedOrigin { Name: var first }) taken[(at.X, at.Y)] = first;
        foreach (var (name, reached) in following.Elsewhere)
        {
            var other = Find(memory, place, new OriginRequest.NamedOrigin(name), profile, default);
            var refusal = other.Refusal;
            if (other.Frame is { } frame)
            {
                if (reached is { } extents && memory.IsTravelKnown(profile, place)) refusal = TravelLimits.Refusal(profile, extents, profile, frame, dryRun);
                if (!other.IsAssumed && !taken.TryAdd((frame.X, frame.Y), name)) refusal ??= PreparationRules.SamePlace.At(default, taken[(frame.X, frame.Y)], name);
            }

            if (refusal is not null) return found with { Frame = null, Refusal = refusal, IsWithinTravel = false, RefusedOrigin = name };
        }

        return found;
    }

    /// <summary>Why a position from the controller's own zero is not a certain position of the machine; null when it is one.</summary>
    public static Diagnostic? PositionDoubt(StoredMachineState memory, ControllerPosition place, MachineProfile profile) => NotHomed(memory, place, profile) ?? ZeroDoubt(memory, place);

    /// <summary>Why the machine has to be homed first, or used with another profile; null where it is homed, or need not be.</summary>
    /// <remarks>A machine that was homed is known under its own profile: with another one its counts would be other millimetres, and its travel and its tool
    /// would be those of another machine.</remarks>
    public static Diagnostic? NotHomed(StoredMachineState memory, ControllerPosition place, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(memory);
        ArgumentNullException.ThrowIfNull(place);
        ArgumentNullException.ThrowIfNull(profile);
        if (!profile.HasHoming) return memory.HomedAs.Length > 0 && memory.IsSameZero(place) ? PreparationRules.OtherProfile.At(default) : null;
        if (memory.IsHomedAt(profile, place)) return null;
        if (place.Doubt.Length > 0) return PreparationRules.PositionDoubted.At(default, place.Doubt);
        return memory.HomedAs == profile.HomedAs && memory.IsSameZero(place) && memory.HomedAxes.DifferenceFrom(profile) is { } other
            ? PreparationRules.HomedByOtherCounts.At(default, NumberText.Rounded(other.Stored.Counts, 3), other.Axis, NumberText.Rounded(other.Current.Counts, 3))
            : PreparationRules.NotHomed.At(default);
    }

    /// <summary>Why an origin is not valid under a profile with other axes or other counts per millimetre; null where they are the same, or unknown.</summary>
    private static Diagnostic? OtherAxes(string name, WorkOrigin origin, MachineProfile profile) => origin.Axes.DifferenceFrom(profile) switch
    {
        null => null,
        { IsOtherLetter: true } other => PreparationRules.SetByOtherAxis.At(default, name, other.Axis, $"{other.Stored.Letter}", $"{other.Current.Letter}"),
        { } other => PreparationRules.SetByOtherCounts.At(default, name, NumberText.Rounded(other.Stored.Counts, 3), other.Axis, NumberText.Rounded(other.Current.Counts, 3)),
    };

    /// <summary>Why the controller's position cannot be trusted according to what is stored; null when it can.</summary>
    public static Diagnostic? ZeroDoubt(StoredMachineState memory, ControllerPosition place)
    {
        ArgumentNullException.ThrowIfNull(memory);
        ArgumentNullException.ThrowIfNull(place);
        var doubt = place.Doubt.Length > 0 ? place.Doubt : memory.Lost;
        if (doubt.Length > 0) return PreparationRules.PositionDoubted.At(default, doubt);
        if (memory.IsSameZero(place) || memory.Mark is null) return null;
        return memory.HomedAs.Length == 0 && memory.Origins.Values.All(origin => origin.IsAssumed) && memory.RestsAtZero && place.Position == default ? null : PreparationRules.ZeroLost.At(default, memory.Active);
    }

    /// <summary>The height at which a tool on a tool axis travels above the work: its present height, or its clearance height where it is lower.</summary>
    /// <param name="profile">Profile of a machine with <see cref="MachineProfile.Height"/>.</param>
    /// <returns>Counts from the controller's own zero; or why the height of the work is unknown.</returns>
    public static (int? Height, Diagnostic? Refusal) TravelHeight(StoredMachineState memory, ControllerPosition place, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(memory);
        ArgumentNullException.ThrowIfNull(place);
        ArgumentNullException.ThrowIfNull(profile);
        if (ZeroDoubt(memory, place) is { } lost) return (null, lost);
        if (memory.ActiveOrigin?.Z is null && memory.IsHomedAt(profile, place) && IsAtTop(place, profile)) return (place.Position.Z, null);
        if (memory.ActiveOrigin?.Z is not { } work) return (null, PreparationRules.HeightNotSet.At(default, memory.Active));
        var clearance = work + profile.ClearanceCounts;
        return (profile.IsLower(place.Position.Z, clearance) ? clearance : place.Position.Z, null);
    }

    /// <summary>Whether the tool is as high as the homing leaves it, on a machine that homes it upwards: there it is above any work.</summary>
    private static bool IsAtTop(ControllerPosition place, MachineProfile profile)
    {
        if (profile.Axes.Z?.Homing is not { } homing) return false;
        var mark = profile.Scale.ToHeight(homing.Zero);
        var home = profile.Scale.ToHeight(homing.Zero - (homing.Plus ? homing.BackOff : -homing.BackOff));
        return profile.IsLower(home, mark) && !profile.IsLower(place.Position.Z, home);
    }

    private static PlacementResult Present(ControllerPosition place, CountsPoint start) =>
        Placed((place.Position - start) with { Z = place.Position.Z }, OriginSource.Here);

    /// <summary>The position in plan is typed; the height is that of the active work origin.</summary>
    private static PlacementResult Given(StoredMachineState memory, ControllerPosition place, Point2D at, MachineProfile profile)
    {
        if ((place.Doubt.Length > 0 ? place.Doubt : memory.Lost) is { Length: > 0 } doubt) return Refused(PreparationRules.PositionDoubted.At(default, doubt));
        if (!profile.Scale.IsInRange(Bounds2D.FromCorners(at, at), default)) return Refused(PreparationRules.OriginTooFar.At(default, NumberText.Rounded(at.X, 3), NumberText.Rounded(at.Y, 3)));
        if (profile.Height is null) return Placed(profile.Scale.ToCounts(at), OriginSource.Given);
        if (memory.ActiveOrigin is { Z: not null } origin && (ZeroDoubt(memory, place) ?? OtherAxes(memory.Active, origin, profile)) is { } unusable) return Refused(unusable);
        return HeightOf(memory.ActiveOrigin, place) is { } height ? Placed(profile.Scale.ToCounts(at) with { Z = height }, OriginSource.Given) : Refused(PreparationRules.OriginHalfSet.At(default, memory.Active, MachineAxes.Names[2].ToString()));
    }

    /// <summary>Where no origin was set and the controller counts 0 in all axes, a job's work is assumed to be there, in height as in plan, and the list before
    /// the start states it; otherwise null.</summary>
    private static int? HeightOf(WorkOrigin? origin, ControllerPosition place) => origin?.Z ?? (place.Position == default && origin is null or { IsAssumed: true } ? 0 : null);

    /// <param name="assumesZero">An origin that is not set is where the controller counts 0, if the machine is there.</param>
    private static PlacementResult Work(StoredMachineState memory, ControllerPosition place, MachineProfile profile, bool assumesZero)
    {
        if (ZeroDoubt(memory, place) is { } lost) return Refused(lost);
        if (memory.ActiveOrigin is { } origin)
        {
            if (OtherAxes(memory.Active, origin, profile) is { } other) return Refused(other);
            if (origin.Plane is not { } set) return Refused(PreparationRules.OriginHalfSet.At(default, memory.Active, MachineAxes.Names[origin.X is null ? 0 : 1].ToString()));
            if (profile.Height is null) return Placed(set with { Z = 0 }, OriginSource.Work);
            return HeightOf(origin, place) is { } height ? Placed(set with { Z = height }, OriginSource.Work) : Refused(PreparationRules.OriginHalfSet.At(default, memory.Active, MachineAxes.Names[2].ToString()));
        }

        if (assumesZero && place.Position == default) return Placed(default, OriginSource.Work) with { IsAssumed = true };
        var scale = profile.Scale;
        var plane = $"{NumberText.Rounded(scale.X.ToMillimetres(place.Position.X), 3)}, {NumberText.Rounded(scale.Y.ToMillimetres(place.Position.Y), 3)}";
        return Refused(PreparationRules.NoOrigin.At(default, memory.Active, profile.Axes.Z is null ? plane : $"{plane}, {NumberText.Rounded(scale.ToMillimetres(place.Position.Z), 3)}"));
    }

    private static PlacementResult Placed(CountsPoint frame, OriginSource source) => new(frame, source, null);

    private static PlacementResult Refused(Diagnostic refusal) => new(null, OriginSource.Work, refusal);
}
