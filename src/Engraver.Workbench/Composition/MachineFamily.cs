using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Links;

namespace Engraver.Workbench.Composition;

/// <summary>The family of controllers that this workbench drives, and what it says of itself while none is connected.</summary>
public static class MachineFamily
{
    /// <summary>What a machine profile may hold.</summary>
    public static MachineLimits Limits => DmcLimits.Machine;

    /// <summary>Why a serial line cannot be used on this system; null where it can.</summary>
    public static string? WhyNoSerialLine => SerialLink.WhyUnsupported;
}
