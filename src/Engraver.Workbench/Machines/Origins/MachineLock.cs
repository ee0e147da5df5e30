using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>Ensures that one host at a time uses a machine: a file opened without sharing, and a second file that names its owner. The system closes the first
/// when the process ends.</summary>
internal sealed class MachineLock : IDisposable
{
    private const string LockSuffix = ".lock";
    private const string HolderSuffix = ".holder";
    private readonly FileStream _file;

    private MachineLock(FileStream file) => _file = file;

    /// <param name="path">The locked file.</param>
    /// <param name="machine">Name of the machine for the message.</param>
    /// <param name="holder">Name of the new owner.</param>
    /// <exception cref="MachineTakenException">Another host uses it.</exception>
    /// <exception cref="IOException">The folder cannot be written.</exception>
    public static MachineLock Take(string path, string machine, string holder)
    {
        FileStream file;
        try
        {
            file = new FileStream(path + LockSuffix, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
        }
        catch (IOException taken) when (File.Exists(path + LockSuffix))
        {
            throw new MachineTakenException(Wording.Get("Origins.InUse", machine, HolderOf(path)), taken);
        }

        var kept = false;
        try
        {
            OutputFile.Write(path + HolderSuffix, text => text.Write(holder));
            kept = true;
            return new MachineLock(file);
        }
        finally
        {
            if (!kept) file.Dispose();
        }
    }

    public void Dispose() => _file.Dispose();

    private static string HolderOf(string path)
    {
        try
        {
            return File.ReadAllText(path + HolderSuffix) is { Length: > 0 } holder ? holder : Wording.Get("Origins.AnotherProgram");
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return Wording.Get("Origins.AnotherProgram");
        }
    }
}

/// <summary>Names the host that uses a machine.</summary>
public static class MachineHolder
{
    /// <summary>A phrase that names this process, for the messages of other hosts.</summary>
    public static string Describe(string program, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(time);
        return Wording.Get("Origins.Holder", program, Environment.ProcessId, time.GetLocalNow());
    }
}
