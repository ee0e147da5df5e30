using Engraver.Core.Machines;
using Engraver.Core.Operations;

namespace Engraver.Galil.Programs;

/// <summary>What programs and runs of a controller do of operations. The power of a beam is an analog output (galil-dmc.md C, OF), which changes like other
/// outputs when its command is executed and not at a place of the path (galil-dmc.md D).</summary>
internal static class ProgramSupport
{
    /// <param name="target">The format or the family, for messages.</param>
    public static OperationSupport On(string target, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return new OperationSupport(target) { HasPower = profile.Power is not null };
    }
}
