namespace Engraver.Workbench.Machines.Origins;

/// <summary>Names the host that uses a machine.</summary>
public static class LeaseOwner
{
    /// <summary>A phrase that names this process, for the messages of other hosts.</summary>
    public static string Describe(string program, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(time);
        return Wording.Get("Origins.Holder", program, Environment.ProcessId, time.GetLocalNow());
    }
}
