namespace Engraver.Workbench.Playback;

/// <summary>Plays the planned motion: a position in time that runs by the clock, faster or slower, or is put where the operator drags it.</summary>
/// <remarks>The position is computed when it is asked for; whoever draws asks once a picture. Any thread.</remarks>
public sealed class PlaybackSession(TimeProvider time)
{
    private readonly Lock _guard = new();
    private PlannedMotion? _motion;
    private double _position;
    private double _speed = 1.0;
    private long? _since;
    private bool _isPlaced;

    /// <summary>Raised when playing begins or ends, the position is set, the speed or the motion changes; not while it merely runs.</summary>
    public event EventHandler? Changed;

    /// <summary>What is played; null before the first drawing.</summary>
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
            lock (_guard) return _since is not null && Now() < Duration;
        }
    }

    /// <summary>It plays, or the operator has put it somewhere or paused it; not while it waits at its beginning, after it has played to its end, or while
    /// it follows a machine.</summary>
    public bool IsShown
    {
        get
        {
            lock (_guard) return _since is null ? _isPlaced : Now() < Duration;
        }
    }

    /// <summary>Seconds of planned time.</summary>
    public double Position
    {
        get
        {
            lock (_guard) return Now();
        }
    }

    /// <summary>Planned seconds for each second of the clock, above 0; infinite goes to the end at once.</summary>
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

    /// <summary>What the tool does now; null without a motion.</summary>
    public PlaybackMoment? Moment
    {
        get
        {
            lock (_guard) return _motion?.At(Now());
        }
    }

    private double Duration => _motion?.DurationSeconds ?? 0.0;

    /// <summary>Another motion: the position goes to its beginning and waits.</summary>
    public void Load(PlannedMotion? motion) => Set(() => (_motion, _position, _since, _isPlaced) = (motion, 0.0, null, false));

    /// <summary>Runs from where it is, from the beginning when it is at the end.</summary>
    public void Play() => Set(() =>
    {
        if (_position >= Duration) _position = 0.0;
        _since = _motion is null ? null : time.GetTimestamp();
        _isPlaced = _motion is not null;
    });

    public void Pause() => Set(() => _since = null);

    /// <summary>Puts the position somewhere; a playback that runs goes on from there.</summary>
    public void Scrub(double seconds) => Set(() =>
    {
        _position = Inside(seconds);
        _isPlaced = _position > 0.0;
    });

    /// <summary>Puts the position where a machine has come to, which shows its place itself.</summary>
    public void Follow(double seconds) => Set(() => (_position, _isPlaced) = (Inside(seconds), false));

    /// <summary>To the moment at which a row of the sequenced table begins; false when it is not cut.</summary>
    public bool GoToRow(int row) => GoTo(Motion?.TimeOfRow(row));

    /// <summary>To the moment at which an entity that was picked is cut. Whether the place is shown does not change.</summary>
    public bool GoToEntity(int entity)
    {
        if (Motion?.TimeOfEntity(entity) is not { } at) return false;
        Set(() => _position = Inside(at));
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

    private double Inside(double seconds) => double.IsNaN(seconds) ? 0.0 : Math.Clamp(seconds, 0.0, Duration);

    private double Now()
    {
        if (_since is not { } since) return _position;
        var run = time.GetElapsedTime(since).TotalSeconds;
        return double.IsInfinity(_speed) ? Duration : Math.Min(Duration, _position + (run * _speed));
    }

    /// <summary>Every change begins with the clock brought up to now.</summary>
    private void Set(Action change)
    {
        lock (_guard)
        {
            _position = Now();
            if (_since is not null && _position >= Duration) (_since, _isPlaced) = (null, false);
            else if (_since is not null) _since = time.GetTimestamp();
            change();
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }
}
