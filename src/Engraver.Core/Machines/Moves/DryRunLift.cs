namespace Engraver.Core.Machines.Moves;

/// <summary>The lift of a dry run on a machine whose tool is moved by an axis: all motion is as in the job, but raised so far that the deepest cut passes at
/// clearance height.</summary>
public static class DryRunLift
{
    /// <summary>Counts of the Z axis to add to the frame; 0 where an output is the tool.</summary>
    public static int Of(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        return program.Profile.Height is null ? 0 : checked((int)Of(program.Profile, MotionExtents.Of(program)));
    }

    /// <summary>The counts for a job whose extents are known.</summary>
    internal static long Of(MachineProfile profile, in MotionExtents extents) =>
        profile.Height is null || extents.Cuts is not { } cuts ? 0 : profile.ClearanceCounts - (profile.UpSign < 0 ? cuts.Max : cuts.Min);
}
