using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion.Following;

/// <summary>The electronic cam (galil-dmc.md C.4): slaves follow the encoder of a master axis through a table, with linear interpolation between its points, in
/// every cycle.</summary>
internal sealed class ElectronicCam
{
    public const int Points = 257;
    private const int Segments = Points - 1;
    private const int UsualInterval = 256;
    private readonly MotionKernel _motion;
    private double _seen;
    private long _wraps;

    public ElectronicCam(MotionKernel motion)
    {
        _motion = motion;
        Followers = [.. motion.Axes.Take(Axis.Real).Select(a => new CamFollower(a))];
    }

    /// <summary>One follower for each of the axes A to D; that of the master is not used.</summary>
    public CamFollower[] Followers { get; }

    /// <summary>EA: the master axis; null before EA is given.</summary>
    public Axis? Master { get; set; }

    /// <summary>EB: the cam is on.</summary>
    public bool IsEnabled { get; private set; }

    /// <summary>EM of the master: counts of one cycle.</summary>
    public int Modulus { get; set; }

    /// <summary>EP, first field: counts of the master from one point of the table to the next.</summary>
    public int Interval { get; set; } = UsualInterval;

    /// <summary>EP, second field: shifts the table along the master's position, also while the cam runs.</summary>
    public int Shift { get; set; }

    /// <summary>EC: the next point that ET without an index sets.</summary>
    public int Index { get; set; }

    /// <summary>The master's encoder, counted within its cycle.</summary>
    public double MasterPlace => Master?.Motor.Position ?? 0;

    /// <summary>The master's position in the table, from 0 to the modulus.</summary>
    public double Phase { get; private set; }

    /// <summary>Counts cycles of the table; the difference of two values is the number of times that the table's end was passed.</summary>
    public long CycleNumber { get; private set; }

    /// <summary>The master has moved since the slaves last followed it.</summary>
    public bool IsBehind => MasterPlace != _seen;

    public bool Contains(double masterPlace) => masterPlace >= 0 && masterPlace < Modulus;

    /// <summary>EB 1: from now on the master's position is counted within its cycle.</summary>
    /// <exception cref="CommandRefusedException">TC 102 without a master, TC 103 when the table is too short for the cycle.</exception>
    public void Enable()
    {
        if (Master is null || Modulus == 0) throw new CommandRefusedException(Tc.NoCamMaster);
        if (Modulus > (long)Segments * Interval) throw new CommandRefusedException(Tc.CamModulusTooLarge);
        IsEnabled = true;
        WrapMaster();
        Update();
    }

    /// <summary>EB 0, AB: every slave stops at once.</summary>
    public void Disable(int code)
    {
        foreach (var follower in Followers) follower.Release(code);
        IsEnabled = false;
    }

    /// <summary>RS: removes the master and the table.</summary>
    public void Reset()
    {
        (Master, Modulus, Interval, Shift, Index) = (null, 0, UsualInterval, 0, 0);
        foreach (var follower in Followers) follower.Clear();
    }

    /// <summary>Computes one sample: the slaves move to the table positions for the master's position at the start of the sample.</summary>
    /// <returns>Number of slaves that the table drove into a limit switch; they are stopped.</returns>
    public int Step()
    {
        var hits = 0;
        var distance = MasterPlace - _seen;
        WrapMaster();
        Update();
        foreach (var follower in Followers)
        {
            if (follower.IsEngaged && follower.Axis.RunsIntoLimit(follower.Heading(this), out var code))
            {
                follower.Release(code);
                hits++;
            }
            else
            {
                follower.Step(this, distance);
            }
        }

        return hits;
    }

    /// <summary>True when the master passed this position of its cycle in its last <paramref name="distance"/> counts.</summary>
    public bool Passed(double place, double distance)
    {
        var behind = distance > 0 ? MasterPlace - place : place - MasterPlace;
        return distance != 0 && behind - (Math.Floor(behind / Modulus) * Modulus) < Math.Abs(distance);
    }

    public double ValueAt(ReadOnlySpan<int> points, double phase)
    {
        var segment = Math.Min((int)(phase / Interval), Segments - 1);
        var share = (phase - ((double)segment * Interval)) / Interval;
        return points[segment] + (((double)points[segment + 1] - points[segment]) * share);
    }

    /// <summary>After EP or a step of the master: recomputes the phase and the cycle number.</summary>
    public void Update()
    {
        _seen = MasterPlace;
        var turns = Math.Floor((MasterPlace - Shift) / Modulus);
        Phase = MasterPlace - Shift - (turns * Modulus);
        CycleNumber = _wraps + (long)turns;
    }

    /// <summary>Keeps the master's position within one cycle (C.4); its motion continues unchanged.</summary>
    private void WrapMaster()
    {
        var turns = Math.Floor(MasterPlace / Modulus);
        if (turns == 0) return;
        _wraps += (long)turns;
        _motion.Renumber(Master!, -turns * Modulus);
    }
}
