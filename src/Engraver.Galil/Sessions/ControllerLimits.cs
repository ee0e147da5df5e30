namespace Engraver.Galil.Sessions;

/// <summary>What the controller says it has left, asked and not assumed (galil-dmc.md J 16). Null where it does not know the question.</summary>
/// <param name="Labels">_DL.</param>
/// <param name="Variables">_UL.</param>
/// <param name="ArrayElements">_DM.</param>
/// <param name="FreeHandles">_IA2, after both handles of this session were opened.</param>
/// <param name="Segments">_LMS at connect: free places of the vector buffer.</param>
/// <param name="SampleMicroseconds">_TM, nominal.</param>
public sealed record ControllerLimits(int? Labels, int? Variables, int? ArrayElements, int? FreeHandles, int? Segments, int? SampleMicroseconds);
