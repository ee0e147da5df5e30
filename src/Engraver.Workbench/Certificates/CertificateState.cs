namespace Engraver.Workbench.Certificates;

/// <summary>Whether a certificate is valid for the current job.</summary>
public enum CertificateState
{
    /// <summary>No certificate.</summary>
    None,

    /// <summary>Drawing, settings, profile and program match the certificate.</summary>
    Stands,

    /// <summary>Something has changed, or the file cannot be read.</summary>
    Stale,
}
