using Engraver.Core.Machines;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Certificates;

/// <summary>Caches the certificate status of the document's job for a list that is redrawn often. Checks in the background, once for each job and after a
/// certificate was issued.</summary>
/// <remarks>Any thread.</remarks>
public sealed class CertificateMonitor
{
    private readonly Lock _guard = new();
    private PreparedJob? _job;
    private CertificateStatus? _status;
    private int _version;

    /// <summary>Raised when the status of a job is known, on the thread that determined it.</summary>
    public event EventHandler? Changed;

    /// <summary>Null before the first check.</summary>
    public CertificateStatus? StatusOf(PreparedJob job)
    {
        lock (_guard) return ReferenceEquals(job, _job) ? _status : null;
    }

    /// <summary>Checks the certificate of a job.</summary>
    /// <param name="program">The job's program with feeds limited to the link.</param>
    public Task<CertificateStatus> CheckAsync(PreparedJob job, MotionProgram program, CancellationToken cancellation)
    {
        int turn;
        lock (_guard) turn = ++_version;
        return Task.Run(() => Store(job, CertificateStatus.OfRun(job, program), turn), cancellation);
    }

    /// <summary>Discards the status: there is no job.</summary>
    public void Reset()
    {
        lock (_guard)
        {
            _version++;
            (_job, _status) = (null, null);
        }
    }

    private CertificateStatus Store(PreparedJob job, CertificateStatus found, int turn)
    {
        lock (_guard)
        {
            if (turn != _version) return found; // Another job, or another certificate, was checked meanwhile.
            (_job, _status) = (job, found);
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return found;
    }
}
