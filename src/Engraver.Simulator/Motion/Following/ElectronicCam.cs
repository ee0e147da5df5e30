using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion.Following;

/// <summary>The electronic cam (galil-dmc.md C.4): slaves follow the encoder of a master axis through a table, straight from point to point, cycle after cycle.</summary>
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

    /// <summary>One for each of the axes A to D; that of the master is not used.</summary>
    public CamFollower[] Followers { get; }

    /// <summary>EA; null before.</summary>
    public Axis? Master { get; set; }

    /// <summary>EB.</summary>
    public bool IsEnabled { get; private set; }

    /// <summary>EM of the master: counts of one cycle.</summary>
    public int Modulus { get; set; }

    /// <summary>EP, first field: counts of the master from one point of the table to the next.</summary>
    public int Interval { get; set; } = UsualInterval;

    /// <summary>EP, second field: moves the graph to the right, also while the cam runs.</summary>
    public int Shift { get; set; }

    /// <summary>EC: the next point that ET without an index sets.</summary>
    public int Index { get; set; }

    /// <summary>The encoder of the master, within its cycle.</summary>
    public double MasterPlace => Master?.Motor.Position ?? 0;

    /// <summary>Where in the table the master stands, from 0 to the modulus.</summary>
    public double Phase { get; private set; }

    /// <summary>Counts cycles of the table; its difference tells how often the table was passed.</summary>
    public long CycleNumber { get; private set; }

    /// <summary>The master has moved since the slaves looked.</summary>
    public bool IsBehind => MasterPlace != _seen;

    public bool Contains(double masterPlace) => masterPlace >= 0 && masterPlace < Modulus;

    /// <summary>EB 1: from here on the position of the master is told within its cycle.</summary>
    /// <exception cref="CommandRefusedException">TC 102 without a master, TC 103 when the table is too short for the cycle.</exception>
    public void Enable()
    {
        if (Master is null || Modulus == 0) throw new CommandRefusedException(Tc.NoCamMaster);
        if (Modulus > (long)Segments * Interval) throw new CommandRefusedException(Tc.CamModulusTooLarge);
        IsEnabled = true;
        WrapMaster();
        Look();
    }

    /// <summary>EB 0, AB: every slave stands at once.</summary>
    public void Disable(int code)
    {
        foreach (var follower in Followers) follower.Release(code);
        IsEnabled = false;
    }

    /// <summary>RS: no master, no table.</summary>
    public void Reset()
    {
        (Master, Modulus, Interval, Shift, Index) = (null, 0, UsualInterval, 0, 0);
        foreach (var follower in Followers) follower.Clear();
    }

    /// <summary>One sample: the slaves go where the table sends them for the place the master had at its beginning.</summary>
    /// <returns>Slaves that the table drove into a limit switch; they stand.</returns>
    public int Step()
    {
        var hits = 0;
        var distance = MasterPlace - _seen;
        WrapMaster();
        Look();
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

    /// <summary>The master went over a place of its cycle on the last so many counts, which end where it stands.</summary>
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

    /// <summary>EP n or a step of the master: where in the table, and in which cycle.</summary>
    public void Look()
    {
        _seen = MasterPlace;
        var turns = Math.Floor((MasterPlace - Shift) / Modulus);
        Phase = MasterPlace - Shift - (turns * Modulus);
        CycleNumber = _wraps + (long)turns;
    }

    /// <summary>The position of the master is told within one cycle (C.4); its motion goes on untouched.</summary>
    private void WrapMaster()
    {
        var turns = Math.Floor(MasterPlace / Modulus);
        if (turns == 0) return;
        _wraps += (long)turns;
        _motion.Renumber(Master!, -turns * Modulus);
    }
}
