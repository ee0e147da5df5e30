namespace Engraver.Workbench.Files;

/// <summary>A file that is being written beside the place it is for. It is gone when it is disposed of or when the process ends, whatever comes first; only
/// a killed process leaves it.</summary>
/// <remarks>A program that is stopped may end while another thread has half written a result; only a handler at the end of the process can then delete the
/// file.</remarks>
internal sealed class TemporaryFile : IDisposable
{
    private readonly Lock _guard = new();
    private readonly string _target;
    private readonly string _path;
    private bool _over;

    /// <summary>Chooses the temporary name; no file is made yet.</summary>
    public TemporaryFile(string target)
    {
        _target = target;
        _path = $"{target}.{Environment.ProcessId}.tmp";
        AppDomain.CurrentDomain.ProcessExit += OnProcessExit;
    }

    /// <exception cref="IOException">The place cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The place may not be written.</exception>
    /// <exception cref="OperationCanceledException">The process ends.</exception>
    public FileStream Create()
    {
        lock (_guard)
        {
            if (_over) throw new OperationCanceledException();
            return new FileStream(_path, FileMode.Create, FileAccess.Write, FileShare.Delete);
        }
    }

    /// <summary>Replaces the target with what was written.</summary>
    /// <exception cref="IOException">The place cannot be written, or the process ends.</exception>
    public void TakePlace() => File.Move(_path, _target, overwrite: true);

    public void Dispose()
    {
        AppDomain.CurrentDomain.ProcessExit -= OnProcessExit;
        End();
    }

    /// <summary>Deletes the file and lets no new one be made.</summary>
    internal void End()
    {
        lock (_guard)
        {
            _over = true;
            File.Delete(_path);
        }
    }

    private void OnProcessExit(object? sender, EventArgs e)
    {
        try
        {
            End();
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            // The folder is gone or may not be written: the process ends, so nobody can be told.
        }
    }
}
