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

    /// <summary>Where it came to rest last; null before the first motion, and while nobody knows (a job under way, a lost link).</summary>
    public CountsPoint? Rest { get; init; }

    /// <summary>A motion was begun, and nobody has heard yet where it ended.</summary>
    public bool IsMoving { get; init; }

    /// <summary>Why the position has not been known since ("a position error of axis A"), until an origin is set again; empty while it is known.</summary>
    public string Lost { get; init; } = "";

    /// <summary>The active origin; null while it is not set.</summary>
    public WorkOrigin? ActiveOrigin => Origins.GetValueOrDefault(Active);

    /// <summary>True when the controller counts from the same zero as when this was written.</summary>
    public bool IsSameZero(ControllerPlace place)
    {
        ArgumentNullException.ThrowIfNull(place);
        return Mark is { } mark && place.Mark == mark && (Clock is not { } then || place.Clock is not { } now || now >= then);
    }

    /// <summary>True when a controller that lost its zero can have been switched off only where it counted 0, so that its 0 is the same place again.</summary>
    public bool RestsAtZero => !IsMoving && (Rest is null || Rest == default(CountsPoint));

    /// <summary>With one origin set; the axes that are not given keep their places.</summary>
    public MachineMemory WithOrigin(string name, int? x, int? y, int? z)
    {
        var before = Origins.GetValueOrDefault(name) ?? new WorkOrigin(null, null);
        return With(name, new WorkOrigin(x ?? before.X, y ?? before.Y, z ?? before.Z));
    }

    /// <summary>With the place at which the controller counts 0 as the active origin, as long as nobody sets one.</summary>
    public MachineMemory AssumeZero() => With(Active, new WorkOrigin(0, 0) { IsAssumed = true });

    /// <summary>Without the origins: the controller counts from another zero now, and what they told is nowhere.</summary>
    public MachineMemory Forget() => this with { Origins = new Dictionary<string, WorkOrigin>(), Lost = "" };

    private MachineMemory With(string name, WorkOrigin origin) => this with { Origins = new Dictionary<string, WorkOrigin>(Origins) { [name] = origin } };
}
