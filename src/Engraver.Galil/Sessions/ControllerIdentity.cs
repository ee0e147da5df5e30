using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Sessions;

/// <summary>The controller at the other end of the link.</summary>
/// <param name="Model">The reply to ^R^V, for example <c>DMC2143 Rev 1.0o</c>.</param>
/// <param name="Axes">Number of axes, from the model string (galil-dmc.md G).</param>
/// <param name="Handle">The reply to WH for the command handle: IHA to IHH, or RS232.</param>
/// <param name="RecordBytes">Bytes of a QR record by QZ: header, general, coordinated and axis blocks (galil-dmc.md A.9); null when the controller refuses
/// the query (a job does not need it).</param>
public sealed record ControllerIdentity(string Model, int Axes, string Handle, int? RecordBytes, ControllerLimits Limits) : MachineIdentity(Model, Axes)
{
    /// <summary>The letters of the axes: ABCD for four.</summary>
    public string Letters => DmcAxes.All[..Axes];
}

/// <summary>Free memory and other limits, as reported by the controller (galil-dmc.md J 16). Null if it does not support the query.</summary>
/// <param name="Labels">_DL.</param>
/// <param name="Variables">_UL.</param>
/// <param name="ArrayElements">_DM.</param>
/// <param name="FreeHandles">_IA2, after both handles of this session were opened.</param>
/// <param name="Segments">_LMS at connect: free places of the vector buffer.</param>
/// <param name="SampleMicroseconds">_TM, nominal.</param>
public sealed record ControllerLimits(int? Labels, int? Variables, int? ArrayElements, int? FreeHandles, int? Segments, int? SampleMicroseconds);
