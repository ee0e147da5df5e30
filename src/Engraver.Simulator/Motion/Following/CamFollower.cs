namespace Engraver.Simulator.Motion.Following;

/// <summary>One axis as a slave of the electronic cam (galil-dmc.md C.4): its column of the table, its cycle, and whether it is engaged.</summary>
internal sealed class CamFollower(Axis axis)
{
    /// <summary>ET[0] to ET[256].</summary>
    private readonly int[] _points = new int[ElectronicCam.Points];
    private double? _engageAt;
    private double? _disengageAt;
    private long _cycle;

    public Axis Axis => axis;

    /// <summary>EM: counts that the slave moves in one cycle of the master, unsigned; 0 when it returns to its start position.</summary>
    public int Cycle { get; set; }

    /// <summary><c>_EGx</c>: the slave follows the table.</summary>
    public bool IsEngaged { get; private set; }

    /// <summary><c>_EQx</c>: 1 waits to engage, 2 waits to disengage, 3 both.</summary>
    public int Waiting => (_engageAt is null ? 0 : 1) + (_disengageAt is null ? 0 : 2);

    /// <summary>Counts that the slave moved in the last sample.</summary>
    public int LastStep { get; private set; }

    public int this[int point]
    {
        get => _points[point];
        set => _points[point] = value;
    }

    /// <summary>Requests engagement: EG.</summary>
    public void Engage(ElectronicCam cam, double at)
    {
        if (cam.Contains(at) && at != cam.MasterPlace) _engageAt = at;
        else Start(cam);
    }

    /// <summary>Requests disengagement: EQ.</summary>
    public void Disengage(ElectronicCam cam, double at)
    {
        if (cam.Contains(at) && at != cam.MasterPlace) _disengageAt = at;
        else Release(StopCode.CamStopped);
    }

    /// <summary>Disengages and stops at once, as EQ, ST, AB and limits do.</summary>
    public void Release(int code)
    {
        (_engageAt, _disengageAt) = (null, null);
        if (!IsEngaged) return;
        IsEngaged = false;
        LastStep = 0;
        axis.StopCode = code;
        axis.LastStop = axis.Reference;
    }

    public void Clear()
    {
        Array.Clear(_points);
        Cycle = 0;
    }

    /// <summary>Computes one sample in which the master moved by <paramref name="distance"/> counts.</summary>
    public void Step(ElectronicCam cam, double distance)
    {
        LastStep = 0;
        if (_engageAt is { } from && cam.Passed(from, distance)) Start(cam);
        else if (IsEngaged) Place(cam);
        if (_disengageAt is { } to && cam.Passed(to, distance)) Release(StopCode.CamStopped);
    }

    /// <summary>Signed distance from the slave's position to the position given by the table.</summary>
    public double Heading(ElectronicCam cam) => Target(cam) - axis.Position;

    /// <summary>Counts the slave's position within its cycle, and applies the table from now on: a slave at another position jumps to the table's position
    /// [U].</summary>
    private void Start(ElectronicCam cam)
    {
        _engageAt = null;
        IsEngaged = true;
        _cycle = cam.CycleNumber;
        if (Cycle > 0) axis.Renumber(-Math.Floor(axis.Position / Cycle) * Cycle);
        axis.StopCode = StopCode.CamRunning;
        Place(cam);
    }

    /// <summary>When the master enters another cycle, the slave's position is shifted by its cycle length.</summary>
    private void Place(ElectronicCam cam)
    {
        var target = Target(cam);
        if (cam.CycleNumber != _cycle) axis.Renumber((_cycle - cam.CycleNumber) * NetChange(cam));
        _cycle = cam.CycleNumber;
        LastStep = (int)(target - axis.Position);
        axis.SetPosition(target);
    }

    private double NetChange(ElectronicCam cam) => Math.Sign(cam.ValueAt(_points, cam.Modulus) - _points[0]) * (double)Cycle;

    private double Target(ElectronicCam cam) => Math.Round(cam.ValueAt(_points, cam.Phase), MidpointRounding.AwayFromZero);
}
