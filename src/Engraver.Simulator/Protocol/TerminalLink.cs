namespace Engraver.Simulator.Protocol;

/// <summary>The symbolic link by which a host finds the pseudo-terminal.</summary>
internal static class TerminalLink
{
    private const string Terminals = "/dev/pts/";

    /// <summary>Creates the link. An existing link to a pseudo-terminal is assumed to remain from a killed run and is replaced.</summary>
    /// <exception cref="IOException">Another file has this name, or the folder does not exist.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder cannot be written.</exception>
    public static void Create(string path, string terminal)
    {
        if (new FileInfo(path).LinkTarget is { } target && target.StartsWith(Terminals, StringComparison.Ordinal)) File.Delete(path);
        File.CreateSymbolicLink(path, terminal);
    }

    /// <summary>Removes the link if it still points to this terminal.</summary>
    public static void Remove(string path, string terminal)
    {
        try
        {
            if (new FileInfo(path).LinkTarget == terminal) File.Delete(path);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            // A link that cannot be removed points to a terminal that no longer exists; the next run replaces it.
        }
    }
}
