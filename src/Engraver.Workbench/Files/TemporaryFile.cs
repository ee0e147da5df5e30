namespace Engraver.Workbench.Files;

/// <summary>A temporary file beside its target. It is deleted on dispose or when the process ends; it remains only if the process is killed.</summary>
/// <remarks>A stopped program may end while another thread is writing a result; then only a process exit handler can delete the file.</remarks>
internal sealed class TemporaryFile : IDisposable
{
    private readonly Lock _guard = new();
    private readonly string _target;
    private readonly string _path;
    private bool _isEnded;

    /// <summary>Chooses the temporary name without creating the file.</summary>
    public TemporaryFile(string target)
    {
        _target = target;
        _path = $"{target}.{Environment.ProcessId}.tmp";
        AppDomain.CurrentDomain.ProcessExit += OnProcessExit;
    }

    /// <exception cref="IOException">The path cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    /// <exception cref="OperationCanceledException">The process is ending.</exception>
    public FileStream Create()
    {
        lock (_guard)
        {
            if (_isEnded) throw new OperationCanceledException();
            return new FileStream(_path, FileMode.Create, FileAccess.Write, FileShare.Delete);
        }
    }

    /// <summary>Replaces the target with what was written.</summary>
    /// <exception cref="IOException">The path cannot be written, or the process is ending.</exception>
    public void ReplaceTarget() => File.Move(_path, _target, overwrite: true);

    public void Dispose()
    {
        AppDomain.CurrentDomain.ProcessExit -= OnProcessExit;
        End();
    }

    /// <summary>Deletes the file and prevents a new one.</summary>
    internal void End()
    {
        lock (_guard)
        {
            _isEnded = true;
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
            // The folder does not exist or is not writable. The process is ending, so the error cannot be reported.
        }
    }
}
