namespace Engraver.Workbench.Playback;

/// <summary>Plays the planned motion: a time position that advances with the clock at a selectable speed, or is set by the operator.</summary>
/// <remarks>The position is computed on demand, once per drawn frame. Any thread.</remarks>
public sealed class PlaybackSession(TimeProvider time)
{
    private readonly Lock _guard = new();
    private PlannedMotion? _motion;
    private double _position;
    private double _speed = 1.0;
    private long? _since;
    private bool _isPositioned;

    /// <summary>Raised when playback starts or ends, the position is set, or the speed or the motion changes; not during playback.</summary>
    public event EventHandler? Changed;

    /// <summary>The played motion; null before the first drawing.</summary>
    public PlannedMotion? Motion
    {
        get
        {
            lock (_guard) return _motion;
        }
    }

    public bool IsPlaying
    {
        get
        {
            lock (_guard) return _since is not null && CurrentPosition() < Duration;
        }
    }

    /// <summary>True during playback, and if the operator has set or paused the position; false at the start, after the end, and while it follows a
    /// machine.</summary>
    public bool IsShown
    {
        get
        {
            lock (_guard) return _since is null ? _isPositioned : CurrentPosition() < Duration;
        }
    }

    /// <summary>Seconds of planned time.</summary>
    public double Position
    {
        get
        {
            lock (_guard) return CurrentPosition();
        }
    }

    /// <summary>Planned seconds per clock second, above 0; infinity jumps to the end.</summary>
    public double Speed
    {
        get
        {
            lock (_guard) return _speed;
        }

        set
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            Set(() => _speed = value);
        }
    }

    /// <summary>The current state; null without a motion.</summary>
    public PlaybackMoment? Moment
    {
        get
        {
            lock (_guard) return _motion?.At(CurrentPosition());
        }
    }

    private double Duration => _motion?.DurationSeconds ?? 0.0;

    /// <summary>Sets another motion; the position is reset to its start.</summary>
    public void Load(PlannedMotion? motion) => Set(() => (_motion, _position, _since, _isPositioned) = (motion, 0.0, null, false));

    /// <summary>Plays from the current position, or from the start at the end.</summary>
    public void Play() => Set(() =>
    {
        if (_position >= Duration) _position = 0.0;
        _since = _motion is null ? null : time.GetTimestamp();
        _isPositioned = _motion is not null;
    });

    public void Pause() => Set(() => _since = null);

    /// <summary>Sets the position; a running playback continues from there.</summary>
    public void Scrub(double seconds) => Set(() =>
    {
        _position = Clamp(seconds);
        _isPositioned = _position > 0.0;
    });

    /// <summary>Sets the position to that of a machine, which is displayed separately.</summary>
    public void Follow(double seconds) => Set(() => (_position, _isPositioned) = (Clamp(seconds), false));

    /// <summary>Goes to the start of a row of the sequenced table; false if it is not cut.</summary>
    public bool GoToRow(int row) => GoTo(Motion?.TimeOfRow(row));

    /// <summary>Goes to the time at which a picked entity is cut. Does not change whether the position is shown.</summary>
    public bool GoToEntity(int entity)
    {
        if (Motion?.TimeOfEntity(entity) is not { } at) return false;
        Set(() => _position = Clamp(at));
        return true;
    }

    public bool GoToLine(int line) => GoTo(Motion?.TimeOfLine(line));

    public bool GoToStroke(int stroke) => GoTo(Motion?.TimeOfStroke(stroke));

    private bool GoTo(double? seconds)
    {
        if (seconds is not { } at) return false;
        Scrub(at);
        return true;
    }

    private double Clamp(double seconds) => double.IsNaN(seconds) ? 0.0 : Math.Clamp(seconds, 0.0, Duration);

    private double CurrentPosition()
    {
        if (_since is not { } since) return _position;
        var run = time.GetElapsedTime(since).TotalSeconds;
        return double.IsInfinity(_speed) ? Duration : Math.Min(Duration, _position + (run * _speed));
    }

    /// <summary>Updates the position by the clock before every change.</summary>
    private void Set(Action change)
    {
        lock (_guard)
        {
            _position = CurrentPosition();
            if (_since is not null && _position >= Duration) (_since, _isPositioned) = (null, false);
            else if (_since is not null) _since = time.GetTimestamp();
            change();
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }
}
