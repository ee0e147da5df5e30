using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines;

/// <summary>The operator's requests to a running job apart from its stop: hold, resume, feed and rapid override. Written from any thread, read by the job
/// between two commands (ADR 10).</summary>
/// <remarks>The stop is a separate token and takes precedence over everything here. One control serves one job.</remarks>
public sealed class JobControl
{
    private readonly Lock _guard = new();
    private bool _isHoldWanted;
    private double _feed = 1.0;
    private double _rapid = 1.0;
    private JobPhase _phase;
    private MoveInHold? _move;
    private bool _isCompleted;
    private string? _stopReason;

    /// <summary>Factors of the programmed feed that an operator may request.</summary>
    public static SpeedRange FeedRange { get; } = new(0.1, 2.0);

    /// <summary>Factors of the rapid speed that an operator may request; the rapid speed is the machine's fastest.</summary>
    public static SpeedRange RapidRange { get; } = new(0.1, 1.0);

    /// <summary>Why the job is stopped, as a sentence, where the operator did not stop it; null otherwise. Set before the stop itself.</summary>
    public string? StopReason
    {
        get
        {
            lock (_guard) return _stopReason;
        }

        set
        {
            lock (_guard) _stopReason = value;
        }
    }

    /// <summary>The job is to brake on its path, or to remain held.</summary>
    public bool IsHoldWanted
    {
        get
        {
            lock (_guard) return _isHoldWanted;
        }
    }

    /// <summary>Factor of the programmed feed; limited to <see cref="FeedRange"/>.</summary>
    /// <exception cref="ArgumentException">Not a number.</exception>
    public double FeedRatio
    {
        get
        {
            lock (_guard) return _feed;
        }

        set
        {
            var feed = Within(FeedRange, value);
            lock (_guard) _feed = feed;
        }
    }

    /// <summary>Factor of the rapid speed; limited to <see cref="RapidRange"/>.</summary>
    /// <exception cref="ArgumentException">Not a number.</exception>
    public double RapidRatio
    {
        get
        {
            lock (_guard) return _rapid;
        }

        set
        {
            var rapid = Within(RapidRange, value);
            lock (_guard) _rapid = rapid;
        }
    }

    /// <summary>The phase of the job as last reported by it.</summary>
    public JobPhase Phase
    {
        get
        {
            lock (_guard) return _phase;
        }
    }

    /// <summary>The job brakes at the next point where it can, and the tool is switched off or raised at standstill.</summary>
    public void Hold()
    {
        lock (_guard) _isHoldWanted = true;
    }

    /// <summary>Cancels a hold: the machine returns to where it was held, the tool is switched on or lowered again, and the job continues there.</summary>
    public void Resume()
    {
        lock (_guard) _isHoldWanted = false;
    }

    /// <summary>The hand move that was requested of the held job and has not ended; null for none.</summary>
    public MoveInHold? Move
    {
        get
        {
            lock (_guard) return _move;
        }
    }

    /// <summary>Moves the machine of a held job by hand, tool off or raised; a resume returns to where the job was held.</summary>
    /// <returns>How the move ended; refused where the job is not held at standstill, or another move is in progress.</returns>
    public Task<JobResult> MoveAsync(MoveInHold move)
    {
        ArgumentNullException.ThrowIfNull(move);
        lock (_guard)
        {
            if (_phase != JobPhase.Held || !_isHoldWanted || _isCompleted) return Task.FromResult(JobResult.NotStarted(0, Wording.Get("JobControl.NotHeld")));
            if (_move is not null) return Task.FromResult(JobResult.NotStarted(0, Wording.Get("JobControl.MoveNotFinished")));
            _move = move;
        }

        return move.Ended;
    }

    /// <summary>Called by the job: the requested move has ended.</summary>
    public void CompleteMove(JobResult result)
    {
        MoveInHold? ended;
        lock (_guard) (ended, _move) = (_move, null);
        ended?.Complete(result);
    }

    /// <summary>Called by the job.</summary>
    public void Enter(JobPhase phase)
    {
        lock (_guard) _phase = phase;
    }

    /// <summary>Called by the job: it has ended, together with any requested move.</summary>
    public void Complete(JobResult result)
    {
        lock (_guard) _isCompleted = true;
        CompleteMove(result);
    }

    private static double Within(SpeedRange range, double value) =>
        double.IsNaN(value) ? throw new ArgumentException("A ratio is a number.", nameof(value)) : Math.Clamp(value, range.Min, range.Max);
}
