using Engraver.Core.Machines;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Description of the homing of an axis.</summary>
internal static class HomingText
{
    public static string Sentence(MachineAxis axis)
    {
        var homing = axis.Homing!;
        var (mark, way) = (Wording.Get("HomingMark." + homing.By), homing.Plus ? Wording.Get("CncHome.Plus") : Wording.Get("CncHome.Minus"));
        return Wording.Get("CncHome.Axis", axis.Letter, mark, way, homing.Zero, homing.FastMmPerMinute, homing.SlowMmPerMinute, homing.BackOff);
    }
}
