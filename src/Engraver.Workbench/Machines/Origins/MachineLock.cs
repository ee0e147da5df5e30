using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>Ensures that one host at a time uses a machine: a file opened without sharing, and a second file that names its owner. The system closes the first
/// when the process ends.</summary>
internal sealed class MachineLock : IDisposable
{
    private const string LockSuffix = ".lock";
    private const string OwnerSuffix = ".holder";
    private readonly FileStream _file;

    private MachineLock(FileStream file) => _file = file;

    /// <param name="path">The locked file.</param>
    /// <param name="machine">Name of the machine for the message.</param>
    /// <param name="owner">Name of the new owner.</param>
    /// <exception cref="MachineInUseException">Another host uses it.</exception>
    /// <exception cref="IOException">The folder cannot be written.</exception>
    public static MachineLock Acquire(string path, string machine, string owner)
    {
        FileStream file;
        try
        {
            file = new FileStream(path + LockSuffix, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
        }
        catch (IOException taken) when (File.Exists(path + LockSuffix))
        {
            throw new MachineInUseException(Wording.Get("Origins.InUse", machine, OwnerOf(path)), taken);
        }

        var kept = false;
        try
        {
            OutputFile.Write(path + OwnerSuffix, text => text.Write(owner));
            kept = true;
            return new MachineLock(file);
        }
        finally
        {
            if (!kept) file.Dispose();
        }
    }

    public void Dispose() => _file.Dispose();

    private static string OwnerOf(string path)
    {
        try
        {
            return File.ReadAllText(path + OwnerSuffix) is { Length: > 0 } holder ? holder : Wording.Get("Origins.AnotherProgram");
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return Wording.Get("Origins.AnotherProgram");
        }
    }
}
