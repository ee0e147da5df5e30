namespace Engraver.Core.Machines.Origins;

/// <summary>What is stored of one machine from one session to the next: its work origins, and the values that show that the controller still counts from the
/// same zero. Immutable.</summary>
public sealed record StoredMachineState
{
    /// <summary>A machine of which nothing is known.</summary>
    public static StoredMachineState Empty { get; } = new();

    /// <summary>The work origin that jobs use.</summary>
    public string Active { get; init; } = WorkOriginNames.First;

    /// <summary>The origins that were set, by name.</summary>
    public IReadOnlyDictionary<string, WorkOrigin> Origins { get; init; } = new Dictionary<string, WorkOrigin>();

    /// <summary>The same with the origins that were set, without those that a job has assumed.</summary>
    public StoredMachineState WithoutAssumed() => this with { Origins = Origins.Where(origin => !origin.Value.IsAssumed).ToDictionary() };

    /// <summary>The number that was stored in the controller; null before the first session that moved it.</summary>
    public int? Mark { get; init; }

    /// <summary>The controller's clock when it was last read, in its ticks.</summary>
    public double? Clock { get; init; }

    /// <summary>A number to store in a controller: from 1, and a different one each millisecond, so that two sessions do not store the same; a whole number
    /// that the controller keeps exactly.</summary>
    public static int NewMark(DateTimeOffset now) => (int)(now.ToUnixTimeMilliseconds() % 1_999_999_999) + 1;

    /// <summary>Where it last came to rest; null before the first motion, and where it is unknown (a lost link).</summary>
    public CountsPoint? RestPosition { get; init; }

    /// <summary>A motion was started, and its end has not been reported.</summary>
    public bool IsMoving { get; init; }

    /// <summary>Why steppers may have lost steps since the machine last came to rest: they were stopped without a ramp and are no longer at that position. The
    /// controller keeps the reason of a stop; where they are still at that position, the reason is an old one.</summary>
    /// <param name="place">Their present position.</param>
    /// <param name="stoppedHard">Letters of the axes that the controller reports as stopped without a ramp; of them only those without an encoder
    /// matter.</param>
    /// <returns>Empty where no steps may be lost.</returns>
    public string StepLossReason(ControllerPosition place, string stoppedHard)
    {
        ArgumentNullException.ThrowIfNull(place);
        if (!IsMoving && RestPosition is null) return "";
        var (then, now) = (Counts(RestPosition ?? default), Counts(place.Position));
        var axes = string.Concat(MachineAxes.Names.Zip(place.Letters).Where((axis, i) => stoppedHard.Contains(axis.Second, StringComparison.Ordinal) && place.WithoutEncoder.Contains(axis.Second, StringComparison.Ordinal) && (RestPosition is null || then[i] != now[i])).Select(axis => axis.First));
        return axes.Length == 0 ? "" : Wording.Get("Origins.StepperStoppedWithoutRamp", axes);
    }

    private static long[] Counts(CountsPoint point) => [point.X, point.Y, point.Z];

    /// <summary>Why the position has been unknown since ("a position error of axis A"), until an origin is set again; empty while it is known.</summary>
    public string Lost { get; init; } = "";

    /// <summary>How the machine was homed whose zero is stored (<see cref="MachineProfile.HomedAs"/>): that zero is the same position of the machine after each
    /// such homing. Empty: the zero is where the controller was switched on.</summary>
    public string HomedAs { get; init; } = "";

    /// <summary>The axes of the machine profile with which it was homed, without letters.</summary>
    public StoredAxes HomedAxes { get; init; }

    /// <summary>The machine was not homed: it is simulated, ends with its connection, and counts as homed where it started, so that a rehearsal is checked like
    /// a job on the machine.</summary>
    public bool HomingIsAssumed { get; init; }

    /// <summary>A simulated machine that counts as homed by this profile.</summary>
    public StoredMachineState AssumeHomed(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return profile.HasHoming ? this with { HomedAs = profile.HomedAs, HomedAxes = StoredAxes.Of(profile).WithoutLetters(), HomingIsAssumed = true } : this;
    }

    /// <summary>True when the machine was homed as this profile configures it, with the same counts per millimetre.</summary>
    public bool WasHomedBy(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return profile.HasHoming && HomedAs == profile.HomedAs && HomedAxes.DifferenceFrom(profile) is null;
    }

    /// <summary>True when the machine was homed and the controller still counts from there.</summary>
    public bool IsHomedAt(MachineProfile profile, ControllerPosition place)
    {
        ArgumentNullException.ThrowIfNull(place);
        return WasHomedBy(profile) && Lost.Length == 0 && place.Doubt.Length == 0 && IsSameZero(place);
    }

    /// <summary>True when the travel of the profile applies to positions of this machine: it was homed, or it has no homing and its zero is where its owner
    /// switches it on.</summary>
    public bool IsTravelKnown(MachineProfile profile, ControllerPosition place)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(place);
        return profile.HasHoming ? IsHomedAt(profile, place) : Lost.Length == 0 && place.Doubt.Length == 0;
    }

    /// <summary>The active origin; null while it is not set.</summary>
    public WorkOrigin? ActiveOrigin => Origins.GetValueOrDefault(Active);

    /// <summary>True when the controller counts from the same zero as when this was written.</summary>
    public bool IsSameZero(ControllerPosition place)
    {
        ArgumentNullException.ThrowIfNull(place);
        return HomingIsAssumed || (Mark is { } mark && place.Mark == mark && (Clock is not { } then || place.Clock is not { } now || now >= then));
    }

    /// <summary>True when a controller that lost its zero can have been switched off only at 0 counts, so that its 0 is the same position again.</summary>
    public bool RestsAtZero => !IsMoving && (RestPosition is null || RestPosition == default(CountsPoint));

    /// <summary>Returns the memory with one origin set; the axes that are not given keep their values.</summary>
    /// <param name="axes">Axes of the machine profile with which it is set. A value that was stored without its own axes and counts per millimetre takes
    /// these.</param>
    public StoredMachineState WithOrigin(string name, long? x, long? y, int? z, StoredAxes axes = default)
    {
        var before = Origins.GetValueOrDefault(name) ?? new WorkOrigin(null, null);
        var kept = new StoredAxes(x is null ? before.Axes.X : null, y is null ? before.Axes.Y : null, z is null ? before.Axes.Z : null);
        var origin = new WorkOrigin(x ?? before.X, y ?? before.Y, z ?? before.Z);
        return With(name, origin with { Axes = kept.Or(axes).For(origin) });
    }

    /// <summary>Called before a job uses the active origin: where the file of an older version does not state with which axes and counts per millimetre it was
    /// set, and the machine homed, those of this profile are taken.</summary>
    public StoredMachineState UsedBy(MachineProfile profile) => UsedBy(profile, Active);

    /// <summary>The same for the origin with a name.</summary>
    public StoredMachineState UsedBy(MachineProfile profile, string name)
    {
        ArgumentNullException.ThrowIfNull(profile);
        var axes = StoredAxes.Of(profile);
        var homed = WasHomedBy(profile) ? this with { HomedAxes = HomedAxes.Or(axes.WithoutLetters()) } : this;
        return Origins.GetValueOrDefault(name) is { IsAssumed: false } origin ? homed.With(name, origin with { Axes = origin.Axes.Or(axes).For(origin) }) : homed;
    }

    /// <summary>Returns the memory with the point at which the controller counts 0 as the active origin, as long as none is set.</summary>
    /// <param name="hasHeight">The machine has a Z axis.</param>
    public StoredMachineState AssumeZero(bool hasHeight = false) => AssumeZero(Active, hasHeight);

    /// <summary>The same for the origin with a name.</summary>
    /// <param name="hasHeight">The machine has a Z axis.</param>
    public StoredMachineState AssumeZero(string name, bool hasHeight) => With(name, new WorkOrigin(0, 0, hasHeight ? 0 : null) { IsAssumed = true });

    /// <summary>Returns the memory without the origins: the controller now counts from another zero, and their positions are lost.</summary>
    public StoredMachineState Forget() => this with { Origins = new Dictionary<string, WorkOrigin>(), Lost = "", HomedAs = "", HomedAxes = default, HomingIsAssumed = false };

    /// <summary>The machine was homed: the controller now counts from the zero of the homing.</summary>
    /// <param name="profile">The profile with which it was homed.</param>
    /// <param name="shift">What the homing added to the counts of each axis, in the order of <see cref="MachineAxes.All"/>; null when the controller's zero
    /// before it was not that of this memory.</param>
    /// <remarks>Origins that were set under the same homing are at the same positions again, whatever happened in between. Others are shifted with the counts,
    /// or are lost.</remarks>
    public StoredMachineState Homed(MachineProfile profile, IReadOnlyList<int>? shift)
    {
        ArgumentNullException.ThrowIfNull(profile);
        var origins = HomedAs == profile.HomedAs ? Origins
            : shift is null ? new Dictionary<string, WorkOrigin>()
            : Origins.ToDictionary(entry => entry.Key, entry => entry.Value with { X = entry.Value.X + shift[0], Y = entry.Value.Y + shift[1], Z = shift.Count > 2 ? entry.Value.Z + shift[2] : entry.Value.Z });
        return this with { Origins = origins, HomedAs = profile.HomedAs, HomedAxes = StoredAxes.Of(profile).WithoutLetters(), HomingIsAssumed = false, Lost = "" };
    }

    private StoredMachineState With(string name, WorkOrigin origin) => this with { Origins = new Dictionary<string, WorkOrigin>(Origins) { [name] = origin } };
}
