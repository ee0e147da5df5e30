namespace Engraver.Core.Machines.Origins;

/// <summary>What is kept of one machine from one session to the next: its work origins, and by what it is told that the controller still counts from the same zero. Immutable.</summary>
public sealed record MachineMemory
{
    /// <summary>A machine of which nothing is known yet.</summary>
    public static MachineMemory Empty { get; } = new();

    /// <summary>The work origin that jobs use.</summary>
    public string Active { get; init; } = WorkOriginNames.First;

    /// <summary>Those that were set, by name.</summary>
    public IReadOnlyDictionary<string, WorkOrigin> Origins { get; init; } = new Dictionary<string, WorkOrigin>();

    /// <summary>The number that was left in the controller; null before the first session that moved it.</summary>
    public int? Mark { get; init; }

    /// <summary>The controller's clock when it was heard last, in its ticks.</summary>
    public double? Clock { get; init; }

    /// <summary>A number to leave in a controller: from 1, and another one each millisecond, so that no two sessions leave the same; a whole number that the controller keeps exactly.</summary>
    public static int NewMark(DateTimeOffset now) => (int)(now.ToUnixTimeMilliseconds() % 1_999_999_999) + 1;

    /// <summary>Where it came to rest last; null before the first motion, and where nobody knows (a lost link).</summary>
    public CountsPoint? Rest { get; init; }

    /// <summary>A motion was begun, and nobody has heard yet where it ended.</summary>
    public bool IsMoving { get; init; }

    /// <summary>Why steppers may have lost steps since the machine came to rest last: they were stopped without a ramp and do not stand where they stood. The controller keeps the reason of a stop; where they stand there still it is an old one.</summary>
    /// <param name="place">Where they stand.</param>
    /// <param name="stoppedHard">Letters of the axes that the controller says were stopped so; of them only those that nothing counts matter.</param>
    /// <returns>Empty where none may.</returns>
    public string WhyStepsMayBeLost(ControllerPlace place, string stoppedHard)
    {
        ArgumentNullException.ThrowIfNull(place);
        if (!IsMoving && Rest is null) return "";
        var (then, now) = (Counts(Rest ?? default), Counts(place.Position));
        var axes = string.Concat("XYZ".Zip(place.Letters).Where((axis, i) => stoppedHard.Contains(axis.Second, StringComparison.Ordinal) && place.Uncounted.Contains(axis.Second, StringComparison.Ordinal) && (Rest is null || then[i] != now[i])).Select(axis => axis.First));
        return axes.Length == 0 ? "" : Wording.Get("Origins.StepperStoppedWithoutRamp", axes);
    }

    private static long[] Counts(CountsPoint point) => [point.X, point.Y, point.Z];

    /// <summary>Why the position has not been known since ("a position error of axis A"), until an origin is set again; empty while it is known.</summary>
    public string Lost { get; init; } = "";

    /// <summary>How the machine was homed whose zero is kept (<see cref="MachineProfile.HomedAs"/>): that zero is the same place of the machine each time it is homed so. Empty: the zero is wherever the controller was switched on.</summary>
    public string HomedAs { get; init; } = "";

    /// <summary>Of the machine profile by which it was homed, without letters.</summary>
    public KeptAxes HomedAxes { get; init; }

    /// <summary>Nobody homed the machine: it is simulated, ends with its connection, and counts as homed where it began, so that a rehearsal is checked as a job on the machine is.</summary>
    public bool HomingIsAssumed { get; init; }

    /// <summary>A simulated machine that counts as homed by this profile.</summary>
    public MachineMemory AssumeHomed(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return profile.HasHoming ? this with { HomedAs = profile.HomedAs, HomedAxes = KeptAxes.Of(profile).WithoutLetters(), HomingIsAssumed = true } : this;
    }

    /// <summary>True when the machine was homed as this profile says, by the same counts per millimetre.</summary>
    public bool WasHomedBy(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return profile.HasHoming && HomedAs == profile.HomedAs && HomedAxes.DifferenceFrom(profile) is null;
    }

    /// <summary>True when the machine was homed and the controller still counts from there.</summary>
    public bool IsHomedAt(MachineProfile profile, ControllerPlace place)
    {
        ArgumentNullException.ThrowIfNull(place);
        return WasHomedBy(profile) && Lost.Length == 0 && place.Doubt.Length == 0 && IsSameZero(place);
    }

    /// <summary>True when the travel of the profile means places of this machine: it was homed, or it has no homing and its zero is where its owner switches it on.</summary>
    public bool KnowsTravel(MachineProfile profile, ControllerPlace place)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(place);
        return profile.HasHoming ? IsHomedAt(profile, place) : Lost.Length == 0 && place.Doubt.Length == 0;
    }

    /// <summary>The active origin; null while it is not set.</summary>
    public WorkOrigin? ActiveOrigin => Origins.GetValueOrDefault(Active);

    /// <summary>True when the controller counts from the same zero as when this was written.</summary>
    public bool IsSameZero(ControllerPlace place)
    {
        ArgumentNullException.ThrowIfNull(place);
        return HomingIsAssumed || (Mark is { } mark && place.Mark == mark && (Clock is not { } then || place.Clock is not { } now || now >= then));
    }

    /// <summary>True when a controller that lost its zero can have been switched off only where it counted 0, so that its 0 is the same place again.</summary>
    public bool RestsAtZero => !IsMoving && (Rest is null || Rest == default(CountsPoint));

    /// <summary>With one origin set; the axes that are not given keep their places.</summary>
    /// <param name="axes">Of the machine profile by which it is set. What was kept without its own axes and counts per millimetre takes these.</param>
    public MachineMemory WithOrigin(string name, long? x, long? y, int? z, KeptAxes axes = default)
    {
        var before = Origins.GetValueOrDefault(name) ?? new WorkOrigin(null, null);
        var kept = new KeptAxes(x is null ? before.Axes.X : null, y is null ? before.Axes.Y : null, z is null ? before.Axes.Z : null);
        var origin = new WorkOrigin(x ?? before.X, y ?? before.Y, z ?? before.Z);
        return With(name, origin with { Axes = kept.Or(axes).For(origin) });
    }

    /// <summary>A job is about to go by the active origin: where the file of an older version does not tell by which axes and counts per millimetre it was set, and the machine homed, it is by those of this profile.</summary>
    public MachineMemory UsedBy(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        var axes = KeptAxes.Of(profile);
        var homed = WasHomedBy(profile) ? this with { HomedAxes = HomedAxes.Or(axes.WithoutLetters()) } : this;
        return ActiveOrigin is { IsAssumed: false } origin ? homed.With(Active, origin with { Axes = origin.Axes.Or(axes).For(origin) }) : homed;
    }

    /// <summary>With the place at which the controller counts 0 as the active origin, as long as nobody sets one.</summary>
    /// <param name="hasHeight">The machine has a Z axis.</param>
    public MachineMemory AssumeZero(bool hasHeight = false) => With(Active, new WorkOrigin(0, 0, hasHeight ? 0 : null) { IsAssumed = true });

    /// <summary>Without the origins: the controller counts from another zero now, and what they told is nowhere.</summary>
    public MachineMemory Forget() => this with { Origins = new Dictionary<string, WorkOrigin>(), Lost = "", HomedAs = "", HomedAxes = default, HomingIsAssumed = false };

    /// <summary>The machine was homed: the controller counts from the zero of the homing now.</summary>
    /// <param name="profile">By which.</param>
    /// <param name="shift">What the homing added to the counts of each axis, in the order of <see cref="MachineAxes.All"/>; null when the controller's zero before it was not that of this memory.</param>
    /// <remarks>Origins that were set by the same homing are the same places again, whatever happened between. Others move with the counts, or are nowhere.</remarks>
    public MachineMemory Homed(MachineProfile profile, IReadOnlyList<int>? shift)
    {
        ArgumentNullException.ThrowIfNull(profile);
        var origins = HomedAs == profile.HomedAs ? Origins
            : shift is null ? new Dictionary<string, WorkOrigin>()
            : Origins.ToDictionary(entry => entry.Key, entry => entry.Value with { X = entry.Value.X + shift[0], Y = entry.Value.Y + shift[1], Z = shift.Count > 2 ? entry.Value.Z + shift[2] : entry.Value.Z });
        return this with { Origins = origins, HomedAs = profile.HomedAs, HomedAxes = KeptAxes.Of(profile).WithoutLetters(), HomingIsAssumed = false, Lost = "" };
    }

    private MachineMemory With(string name, WorkOrigin origin) => this with { Origins = new Dictionary<string, WorkOrigin>(Origins) { [name] = origin } };
}
