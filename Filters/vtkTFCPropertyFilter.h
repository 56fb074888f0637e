// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTFCPropertyFilter
 * @brief Base of the filters that add properties of a volume, computed from one of its arrays.
 *
 * Input: vtkImageData with point or cell data, chosen with SetInputArrayToProcess() (default: the
 * active scalars). Cell data is a volume of its own, one sample per cell. Any numeric type; the
 * array is read once and converted to float, in which everything is computed. Output: the input
 * with arrays `<input array><suffix>`, float, of the same association; an existing array of that
 * name is replaced. AddArray() names further arrays for which the same is done.
 *
 * Invalid samples are NaN, infinities, magnitudes beyond 1.7e38 and blanked points or cells
 * (vtkGhostType HIDDENPOINT, HIDDENCELL). They take no part in any neighbourhood.
 *
 * Pieces on several processes give the values that one process would (up to rounding, 1e-6
 * relative): ranges are global, and the samples that a neighbourhood needs come from the
 * processes that own them, whether or not upstream delivers ghost layers. When downstream asks for
 * a part of the volume only, the whole of it is still requested: a range and a neighbourhood know
 * no piece. All processes of the controller must update the filter together. Composite datasets are
 * therefore not accepted as distributed input.
 *
 * Memory: 4 bytes per sample and output; 4 more unless the input is a valid single-component float
 * array on a single process, plus 4 per sample of the halo on several, plus what the subclass
 * needs. The need is estimated first and refused when the machine has not that much: the
 * environment variable TFC_MEMORY_LIMIT (MiB per process) lowers what counts as available.
 *
 * Wrong input is reported with vtkErrorMacro, on every process, and the output is then empty. After
 * an abort the output is the input with the arrays that were complete.
 */

#ifndef vtkTFCPropertyFilter_h
#define vtkTFCPropertyFilter_h

#include "vtkPassInputTypeAlgorithm.h"
#include "vtkTFCFiltersModule.h" // For export macro

#include <cstddef> // For std::ptrdiff_t
#include <string>  // For std::string
#include <vector>  // For std::vector

class vtkFieldData;
class vtkImageData;
class vtkMultiProcessController;
class vtkTFCDistributedImage;

class VTKTFCFILTERS_EXPORT vtkTFCPropertyFilter : public vtkPassInputTypeAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkTFCPropertyFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Component of the input array that is used; -1 is the Euclidean norm of all components. Default
   * 0.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Names of further arrays, of the association of the input array. Default: none.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  enum LengthUnitType
  {
    VOXELS = 0, ///< lengths count samples; the lattice is taken as cubic
    WORLD = 1   ///< lengths are world lengths; neighbourhoods are round in space
  };

  ///@{
  /**
   * Unit of the lengths among a subclass's parameters and results. Default VOXELS.
   */
  vtkSetClampMacro(LengthUnit, int, VOXELS, WORLD);
  vtkGetMacro(LengthUnit, int);
  ///@}

  ///@{
  /**
   * The processes that share the volume. Default: the global controller. Null: this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkTFCPropertyFilter();
  ~vtkTFCPropertyFilter() override;

  /**
   * The volume as the subclass sees it: a lattice of samples, x fastest, NaN where invalid, which
   * holds the samples of this process and a halo where the whole volume has one.
   */
  struct Field
  {
    std::string Name;    ///< of the input array
    int Association = 0; ///< of the input array: vtkDataObject::FIELD_ASSOCIATION_...
    const float* Values = nullptr;
    std::ptrdiff_t Size[3] = {};      ///< samples of the lattice, halo included
    std::ptrdiff_t Begin[3] = {};     ///< first sample of this process in the lattice
    std::ptrdiff_t End[3] = {};       ///< one past its last
    std::ptrdiff_t Offset[3] = {};    ///< of the lattice's first sample in the whole volume
    std::ptrdiff_t WholeSize[3] = {}; ///< samples of the whole volume
    bool HasInvalid = false;          ///< whether Values may contain NaN
    double Range[2] = {};             ///< of the valid samples of all processes
    double Spacing[3] = {};           ///< world units between samples; > 0
    double UnitSpacing[3] = {};       ///< the same in LengthUnit: 1, or Spacing

    /// Samples of the lattice, and of this process.
    std::ptrdiff_t GetSize() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
    std::ptrdiff_t GetOwnSize() const
    {
      return (this->End[0] - this->Begin[0]) * (this->End[1] - this->Begin[1]) *
        (this->End[2] - this->Begin[2]);
    }
  };

  /**
   * What is wrong with the parameters and what to do; empty when they are fine. The second is
   * called when the volume is known (all of `field` but Values and HasInvalid), on every process;
   * every process sees the same WholeSize, Range and spacings.
   */
  virtual std::string CheckParameters() const { return {}; }
  virtual std::string CheckField(const Field& vtkNotUsed(field)) const { return {}; }

  /**
   * Samples that a result depends on in each direction: the width of the halo, at least 0.
   */
  virtual int GetHaloWidth(const Field& field) const = 0;

  /**
   * Suffixes of the arrays that ComputeProperties() fills.
   */
  virtual std::vector<std::string> GetSuffixes() const = 0;

  /**
   * Bytes of temporary memory that ComputeProperties() needs beside Values and the outputs.
   */
  virtual double GetTemporaryBytes(const Field& vtkNotUsed(field)) const { return 0.; }

  /**
   * Called once per array before ComputeProperties(), on every process, also on those without
   * samples: the place to communicate. Return false when aborted.
   */
  virtual bool Prepare(const Field& vtkNotUsed(field),
    const vtkTFCDistributedImage& vtkNotUsed(image))
  {
    return true;
  }

  /**
   * Fill one array per suffix for the samples [Begin, End). Return false when aborted. Not called
   * on a process without samples. Must not communicate. Progress: from 0.15 to 1.
   */
  virtual bool ComputeProperties(const Field& field, const std::vector<float*>& outputs) = 0;

  /**
   * Called on every process once an array is complete: the place to tell about it in field data.
   */
  virtual void AddFieldData(const Field& vtkNotUsed(field), vtkFieldData* vtkNotUsed(data)) {}

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Component = 0;
  int LengthUnit = VOXELS;
  vtkMultiProcessController* Controller = nullptr;

private:
  struct Job;
  std::string FindArrays(vtkImageData* input, Job& job);
  void ProcessArrays(Job& job);
  bool ProcessArray(Job& job, size_t index);
  std::string CheckMemory(const Job& job, const Field& field, bool needsCopy) const;

  std::vector<std::string> MoreArrays;

  vtkTFCPropertyFilter(const vtkTFCPropertyFilter&) = delete;
  void operator=(const vtkTFCPropertyFilter&) = delete;
};

#endif
