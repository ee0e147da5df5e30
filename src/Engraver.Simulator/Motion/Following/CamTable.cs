namespace Engraver.Simulator.Motion.Following;

/// <summary>The table of the electronic cam and its cycles, as burned by BV (galil-dmc.md A.6).</summary>
internal sealed class CamTable
{
    private readonly (int Modulus, int Interval, int Shift) _master;
    private readonly (int Cycle, int[] Points)[] _slaves;

    public CamTable(ElectronicCam cam)
    {
        _master = (cam.Modulus, cam.Interval, cam.Shift);
        _slaves = [.. cam.Followers.Select(f => (f.Cycle, Enumerable.Range(0, ElectronicCam.Points).Select(i => f[i]).ToArray()))];
    }

    public void ApplyTo(ElectronicCam cam)
    {
        (cam.Modulus, cam.Interval, cam.Shift) = _master;
        for (var i = 0; i < _slaves.Length; i++)
        {
            cam.Followers[i].Cycle = _slaves[i].Cycle;
            for (var point = 0; point < ElectronicCam.Points; point++) cam.Followers[i][point] = _slaves[i].Points[point];
        }
    }
}
