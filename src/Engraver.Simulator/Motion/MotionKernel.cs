namespace Engraver.Simulator.Motion;

/// <summary>All axes and both planes, one sample at a time (galil-dmc.md I.9 to I.11).</summary>
internal sealed class MotionKernel
{
    public MotionKernel()
    {
        Axes = [.. Enumerable.Range(0, Axis.Letters.Length).Select(i => new Axis(i))];
        Planes = [new VectorPlane('S'), new VectorPlane('T')];
        Selected = Planes[0];
    }

    public Axis[] Axes { get; }

    /// <summary>S and T.</summary>
    public VectorPlane[] Planes { get; }

    /// <summary>The plane that CA selected.</summary>
    public VectorPlane Selected { get; set; }

    /// <summary>Counts ends of moves and sequences; what waits for an event compares it.</summary>
    public long Ends { get; private set; }

    /// <summary>Counts each axis went along a vector path in the last sample.</summary>
    private readonly int[] _sampleSteps = new int[Axis.Letters.Length];

    /// <summary>Limits hit since <see cref="TakeLimitHits"/>.</summary>
    private int _limitHits;

    /// <summary>True when the next sample will change a position or end a motion.</summary>
    public bool CanProgress
    {
        get
        {
            foreach (var axis in Axes)
            {
                if (axis.IsMoving) return true;
            }

            return Planes[0].CanProgress || Planes[1].CanProgress;
        }
    }

    /// <summary>One sample of everything; true when something moved.</summary>
    public bool Step()
    {
        var moved = false;
        Array.Clear(_sampleSteps);
        foreach (var plane in Planes) moved |= plane.IsActive && StepPlane(plane);

        foreach (var axis in Axes) moved |= axis.IsMoving && StepAxis(axis);

        return moved;
    }

    public bool IsCoordinated(Axis axis) => PlaneOf(axis) is not null;

    /// <summary>The running plane that drives an axis.</summary>
    public VectorPlane? PlaneOf(Axis axis) => Planes[0].Drives(axis) ? Planes[0] : Planes[1].Drives(axis) ? Planes[1] : null;

    public bool IsBusy(Axis axis) => axis.IsMoving || IsCoordinated(axis);

    /// <summary>Signed commanded speed of an axis in counts/s; along a vector path from the last sample.</summary>
    public double VelocityOf(Axis axis) =>
        axis.IsMoving ? axis.Velocity
        : PlaneOf(axis) is { Speed: > 0 } ? _sampleSteps[axis.Index] / Ramp.Sample
        : 0;

    public int TakeLimitHits()
    {
        var hits = _limitHits;
        _limitHits = 0;
        return hits;
    }

    private bool StepPlane(VectorPlane plane)
    {
        Span<int> before = stackalloc int[Axis.Letters.Length];
        for (var i = 0; i < plane.Axes.Length; i++) before[i] = plane.Axes[i].Reference;

        var moved = plane.Step();
        Ends += plane.IsActive ? 0 : 1;
        for (var i = 0; i < plane.Axes.Length; i++)
        {
            var step = plane.Axes[i].Reference - before[i];
            _sampleSteps[plane.Axes[i].Index] = plane.IsActive ? step : 0;
            if (plane is { IsActive: true, IsStopping: false } && plane.Axes[i].RunsIntoLimit(step, out var code))
            {
                _limitHits++;
                plane.Stop(code);
            }
        }

        return moved;
    }

    private bool StepAxis(Axis axis)
    {
        Ends += axis.Step() ? 0 : 1;
        if (axis.IsMoving && !axis.IsStopping && axis.RunsIntoLimit(axis.Velocity, out var code))
        {
            _limitHits++;
            axis.Stop(code);
        }

        return true;
    }
}
